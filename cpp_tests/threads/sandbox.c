/* An example of the reference in a sandbox that ends the process if it opens a file. The library then chooses its threads itself.
 *     sandbox NAME */
#include "programs.h"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

/* The next instruction ends the process if the call of the system is this one. */
#define FORBID(call)                                                                                                   \
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (call), 0, 1), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)

static int forbid_opening_files(void) {
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
    /* Sanitizers open files of their own. */
    return 0;
#else
    struct sock_filter instructions[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
#ifdef SYS_open
        FORBID(SYS_open),
        FORBID(SYS_creat),
#endif
#ifdef SYS_openat2
        FORBID(SYS_openat2),
#endif
        FORBID(SYS_openat),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const struct sock_fprog program = {sizeof instructions / sizeof *instructions, instructions};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
#endif
}

int main(int argc, char **argv) {
    program_main *const example_main = argc == 2 ? find_program(argv[1]) : NULL;
    if (example_main == NULL) return 2;
    if (!forbid_opening_files()) {
        printf("this program has no such sandbox\n");
        return EXIT_SUCCESS;
    }
    return example_main() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
