// The same from the assembler, which prints what it is asked to.
asm(".print \"g++: fatal error: Killed signal terminated program cc1plus\"\n.err");
