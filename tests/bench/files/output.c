/* Files written aside: gone with a signal, links followed. (Standard output that cannot be
 * written to: commands/help.cases; paths that no file can have: store.c.) */
#include "bench/files/output.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/files/atomic_file.h"
#include "bench/files/folder.h"
#include "tests/scratch.h"
#include "tests/text.h"

/* A child ended by a signal in the middle of a file takes the file with it; a file of the
 * parent's stays. */
static void test_signal(int number)
{
    struct atomic_file mine = {0};
    struct message why;
    int before = scratch_files(scratch), outcome = 0;

    REQUIRE(atomic_file_open(scratch_path("parent.txt"), &mine, &why) == STATUS_OK);
    fflush(stdout);
    pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        struct output *out = NULL;
        signal(number, SIG_DFL); /* ignored in some background shells */
        atomic_file_catch_signals();
        /* one that is whole by then stays, and its name aside is forgotten */
        if (output_create(scratch_path("whole.txt"), &out, &why) != STATUS_OK ||
            output_close(&out, &why) != STATUS_OK)
            _exit(1);
        for (int n = 0; n < 3; n++)
            if (output_create(scratch_path("child.txt"), &out, &why) != STATUS_OK ||
                scratch_files(scratch) != before + 3 + n)
                _exit(1);
        output_print(out, "half");
        raise(number);
        _exit(2);
    }
    REQUIRE(waitpid(child, &outcome, 0) == child);
    CHECK(WIFSIGNALED(outcome) && WTERMSIG(outcome) == number);
    CHECK(scratch_files(scratch) == before + 2 && unlink(scratch_path("whole.txt")) == 0);
    atomic_file_discard(&mine);
    CHECK(scratch_files(scratch) == before);
}

/* A symbolic link stays one, and what it points to is replaced; one in a folder, in which
 * the program chose the name, goes, as a pipe does. */
static void test_link(void)
{
    struct output *out = NULL;
    struct message why;
    struct stat info;

    text_write(scratch_path("real.txt"), "");
    REQUIRE(symlink("real.txt", scratch_path("link.txt")) == 0);
    REQUIRE(output_create(scratch_path("link.txt"), &out, &why) == STATUS_OK);
    CHECK(scratch_files(scratch) == 3); /* aside, until it is whole */
    output_print(out, "%d\n", 12345);
    CHECK(output_close(&out, &why) == STATUS_OK);
    CHECK(lstat(scratch_path("link.txt"), &info) == 0 && S_ISLNK(info.st_mode));
    CHECK(stat(scratch_path("real.txt"), &info) == 0 && info.st_size == 6);
    REQUIRE(output_create_in(scratch, "link.txt", &out, &why) == STATUS_OK);
    CHECK(output_close(&out, &why) == STATUS_OK);
    CHECK(lstat(scratch_path("link.txt"), &info) == 0 && S_ISREG(info.st_mode));
    REQUIRE(mkfifo(scratch_path("pipe.txt"), 0600) == 0); /* nobody reads it */
    REQUIRE(output_create_in(NULL, scratch_path("pipe.txt"), &out, &why) == STATUS_OK);
    CHECK(output_close(&out, &why) == STATUS_OK && unlink(scratch_path("pipe.txt")) == 0);
    CHECK(stat(scratch_path("real.txt"), &info) == 0 && info.st_size == 6);
    unlink(scratch_path("link.txt"));
    unlink(scratch_path("real.txt"));
}

/* Nothing is left of a file that is given up. */
static void test_given_up(void)
{
    struct output *out = NULL;

    REQUIRE(output_create(scratch_path("none.txt"), &out, NULL) == STATUS_OK);
    output_print(out, "half");
    output_discard(out);
    output_discard(NULL);
    CHECK(scratch_files(scratch) == 0);
    /* nor of one of which a write failed, though the last ones did not */
    struct message why;
    REQUIRE(output_create(scratch_path("none.txt"), &out, NULL) == STATUS_OK);
    CHECK(fgetc(output_stream(out)) == EOF); /* it is not for reading */
    CHECK(output_close(&out, &why) == STATUS_FILE && strstr(why.text, "Input/output"));
    CHECK(scratch_files(scratch) == 0);
    /* what is written in place stays: it was there before */
    const char *pipe = scratch_path("pipe");
    REQUIRE(mkfifo(pipe, 0600) == 0);
    const int reader = open(pipe, O_RDONLY | O_NONBLOCK);
    REQUIRE(reader >= 0 && output_create(pipe, &out, NULL) == STATUS_OK);
    output_discard(out);
    CHECK(scratch_files(scratch) == 1 && unlink(pipe) == 0);
    close(reader);
}

/* Folders on the way are made, by whoever may; those there are stay as they are. */
static void test_folders(void)
{
    static const struct {
        const char *path, *wrong; /* NULL: it can be made */
    } want[] = {{"x/y/z", NULL},
                {"x/y/z", NULL},
                {"x/yy//w/", NULL},
                {"file/a", "file/a: "},
                {"x/y/file/a", "x/y/file/a: "},
                {"/proc/a/b", "/proc/a: "}};
    static const char *const made[] = {"x/yy/w", "x/yy", "x/y/z", "x/y", "x"};
    struct message why = {""};
    struct stat info;
    char path[5000];

    umask(022);
    REQUIRE(chdir(scratch) == 0 && fclose(fopen("file", "w")) == 0);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        const enum status st = folder_make(want[n].path, &why);
        CHECK(st == (want[n].wrong ? STATUS_FILE : STATUS_OK));
        if (n == 1)
            REQUIRE(rename("file", "x/y/file") == 0 && symlink("x/y/file", "file") == 0);
        CHECK(!want[n].wrong || !strncmp(why.text, want[n].wrong, strlen(want[n].wrong)));
    }
    memset(path, 'a', sizeof path - 1), path[sizeof path - 1] = '\0';
    CHECK(folder_make(path, &why) == STATUS_FILE);
    path[4095] = '\0'; /* too long for the system alone */
    CHECK(folder_make(path, &why) == STATUS_FILE);
    CHECK(unlink("file") == 0 && unlink("x/y/file") == 0);
    for (size_t n = 0; n < sizeof made / sizeof *made; n++) {
        CHECK(stat(made[n], &info) == 0 && (info.st_mode & 07777) == 0755);
        CHECK(rmdir(made[n]) == 0);
    }
}

int main(void)
{
    scratch_open();
    test_folders();
    const int open = scratch_files("/proc/self/fd");
    test_signal(SIGINT);
    test_signal(SIGTERM);
    test_signal(SIGHUP);
    test_link();
    test_given_up();
    CHECK(scratch_files("/proc/self/fd") == open);
    CHECK(scratch_files(scratch) == 0);
    return check_result();
}
