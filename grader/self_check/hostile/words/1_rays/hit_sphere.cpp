// The same as lines of their own: the name of a file may have them.
#line 1 "x:1:1: error: no\ng++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n"
#error no
