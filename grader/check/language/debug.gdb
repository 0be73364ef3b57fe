# For ./run debug. Breakpoint 1 is grader::check::at_smallest_failure, all others are the learner's functions:
# they count only once the smallest input that fails is about to be tried again.
set pagination off
set print frame-arguments scalars
set $failed = 0
skip -gfi /usr/include/*
skip -gfi /usr/include/*/*
skip -gfi /usr/include/*/*/*
disable
enable 1
commands 1
silent
set $failed = 1
end
run
if $failed == 1
  enable
  disable 1
  continue
  echo \nThis is your function, called with the smallest input that fails.\n
  info args
else
  if $_isvoid($_exitcode) == 0
    echo \nNothing failed, in one process and with the reference for all other tasks.\n
    quit
  else
    echo \nThe program stopped by itself; bt shows where.\n
    bt 8
  end
end
