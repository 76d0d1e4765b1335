/* Memory that never fails: zeroed, aligned, of any size, gone together; and how a process
 * ends that has none. */
#include "bench/files/arena.h"

#include <stdint.h>
#include <sys/wait.h>

#include "bench/files/atomic_file.h"
#include "tests/scratch.h"

static void check_taken(void)
{
    struct arena a = {0};
    int *numbers = NULL;

    for (size_t n = 0; n < 40; n++) {
        unsigned char *bytes = arena_take(&a, n, 3);
        unsigned sum = 0;
        for (size_t k = 0; k < 3 * n; k++)
            sum += bytes[k]--;
        CHECK(!sum && (uintptr_t)bytes % _Alignof(max_align_t) == 0);
        numbers = arena_more(&a, numbers, n, sizeof *numbers);
        numbers[n] = (int)n;
    }
    for (int n = 0; n < 40; n++)
        CHECK(numbers[n] == n);
    char *text = arena_keep(&a, strdup("kept"));
    CHECK(!strcmp(arena_print(&a, "%s %d", text, 7), "kept 7"));
    arena_clear(&a);
    CHECK(!a.last);
    arena_clear(&a);
}

enum { ENDS = 2 };

static void end(int how)
{
    struct arena a = {0};

    if (how == 0)
        arena_take(&a, SIZE_MAX / 4, 8); /* more than there are bytes */
    else
        arena_keep(&a, NULL);
}

/* A process without memory leaves no temporary file, exits with 1 and says a sentence. */
static void check_end(void)
{
    for (int how = 0; how < ENDS; how++) {
        struct atomic_file file;
        char said[64] = "";
        int code = 0, pipes[2];
        REQUIRE(pipe(pipes) == 0);
        const pid_t child = fork();
        if (child == 0) {
            dup2(pipes[1], STDERR_FILENO);
            if (atomic_file_open("left.txt", &file, NULL) == STATUS_OK)
                end(how);
            _exit(0);
        }
        close(pipes[1]);
        REQUIRE(child > 0 && waitpid(child, &code, 0) == child);
        CHECK(read(pipes[0], said, sizeof said - 1) > 0);
        close(pipes[0]);
        CHECK(WIFEXITED(code) && WEXITSTATUS(code) == 1);
        CHECK(!strcmp(said, "clothbench: out of memory\n"));
    }
    CHECK(scratch_files(".") == 0);
}

int main(void)
{
    check_taken();
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    check_end();
    return check_result();
}
