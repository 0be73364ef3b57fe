# Turns text files into string constants: cmake -DOUTPUT=FILE.cpp -DHEADER=... -DNAMESPACE=... -DINPUTS=a;b -P this
set(text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(input IN LISTS INPUTS)
  get_filename_component(name ${input} NAME)
  string(MAKE_C_IDENTIFIER ${name} name)
  file(READ ${input} content)
  string(APPEND text "\nconst std::string_view ${name} = R\"firstlight(${content})firstlight\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}\n}  // namespace ${NAMESPACE}\n")
