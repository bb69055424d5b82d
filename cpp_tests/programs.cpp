// Runs files of add_joined_program, as programs.c does.
#include "programs.c"
