// Does not compile, in a file that is called as bubblewrap begins its errors.
#line 1 "bwrap: x"
#error no
