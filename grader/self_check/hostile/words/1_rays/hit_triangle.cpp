// Does not compile, in the words of a compiler that was killed.
#error Killed signal terminated program cc1plus
