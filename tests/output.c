/* Standard output that cannot be written to is told at the end, with its reason, whether
 * the failure came early (more than a buffer was printed) or only with the last flush. */
#include "bench/output.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/check.h"

/* What main does, in a child whose standard output is `target` (-1: closed): prints `lines`
 * and ends with 0 or 1; the sentence goes to sentence[size]. Returns the exit code, or -1
 * when a signal ended it. */
static int run(int target, int lines, char *sentence, size_t size)
{
    int report[2], outcome = 0;

    REQUIRE(pipe(report) == 0);
    fflush(stdout);
    pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        struct message why = {""};
        output_keep_after_closed_pipe();
        if (target < 0)
            close(STDOUT_FILENO);
        else
            dup2(target, STDOUT_FILENO);
        for (int n = 0; n < lines; n++)
            printf("0.5,0.25,%d\n", n);
        enum status st = output_close_standard(&why);
        (void)!write(report[1], why.text, strlen(why.text));
        _exit(st == STATUS_OK ? 0 : 1);
    }
    close(report[1]);
    ssize_t length = read(report[0], sentence, size - 1);
    sentence[length > 0 ? length : 0] = '\0';
    close(report[0]);
    REQUIRE(waitpid(child, &outcome, 0) == child);
    return WIFEXITED(outcome) ? WEXITSTATUS(outcome) : -1;
}

static void test_full_device(void)
{
    char sentence[256];
    int full = open("/dev/full", O_WRONLY);

    REQUIRE(full >= 0);
    for (int lines = 1; lines <= 100000; lines *= 10) {
        CHECK(run(full, lines, sentence, sizeof sentence) == 1);
        CHECK(!strcmp(sentence, "standard output: cannot be written: No space left on "
                                "device"));
    }
    CHECK(run(full, 0, sentence, sizeof sentence) == 0 && !*sentence);
    close(full);
}

static void test_closed_pipe(void)
{
    char sentence[256];
    int ends[2];

    REQUIRE(pipe(ends) == 0);
    close(ends[0]);
    for (int lines = 1; lines <= 100000; lines *= 10) {
        CHECK(run(ends[1], lines, sentence, sizeof sentence) == 1);
        CHECK(!strcmp(sentence, "standard output: its reader closed the pipe before the "
                                "end"));
    }
    close(ends[1]);
}

static void test_others(void)
{
    char sentence[256];
    int null = open("/dev/null", O_WRONLY);

    REQUIRE(null >= 0);
    CHECK(run(null, 100000, sentence, sizeof sentence) == 0 && !*sentence);
    CHECK(run(-1, 0, sentence, sizeof sentence) == 0 && !*sentence);
    CHECK(run(-1, 1, sentence, sizeof sentence) == 1 && *sentence);
    close(null);
}

int main(void)
{
    test_full_device();
    test_closed_pipe();
    test_others();
    return check_result();
}
