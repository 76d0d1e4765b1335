/* Settings: in order, the last wins, numbers to the bit, and no memory is told. */
#include "bench/harness/contestant.h"

#include "tests/run_fixture.h"

/* The linker sends this program's allocations here (CMakeLists.txt). */
void *__real_realloc(void *old, size_t size);
void *__wrap_realloc(void *old, size_t size);
char *__real_strdup(const char *text);
char *__wrap_strdup(const char *text);

static int left = -1; /* allocations that succeed; negative: all */

static bool fails(void)
{
    return left >= 0 && left-- == 0;
}

void *__wrap_realloc(void *old, size_t size)
{
    return fails() ? NULL : __real_realloc(old, size);
}

char *__wrap_strdup(const char *text)
{
    return fails() ? NULL : __real_strdup(text);
}

static enum status read(const struct settings *s, struct scene *scene,
                        struct discretization *d, struct message *why)
{
    memset(d, 0, sizeof *d);
    return contestant_read_settings(s, DROP, scene, d, why);
}

static void test_order(void)
{
    static const char *const list[3] = {"a=1", "b=2", NULL};
    struct settings s = {0}, more = {0};

    settings_list(&s, 3, list);
    settings_list(&s, 1, list);
    CHECK(s.count == 3 && !strcmp(s.text[1], "b=2") && !strcmp(s.text[2], "a=1"));
    settings_word(&more, "a", "two words");
    settings_integer(&more, "long", -3000000000L);
    settings_integers(&more, "points", 3, (const int[]){10, 9, 2});
    settings_append(&s, &more);
    settings_set_all(&s, 1, (const char *const[]){"ab=3"});
    settings_clear(&more);
    CHECK(s.count == 7 && s.status == STATUS_OK);
    CHECK(!strcmp(settings_value(&s, "a"), "two words")); /* the last */
    CHECK(!strcmp(settings_value(&s, "b"), "2"));
    CHECK(!strcmp(settings_value(&s, "long"), "-3000000000"));
    CHECK(!strcmp(settings_value(&s, "points"), "[10,9,2]"));
    CHECK(!settings_value(&s, "c") && !settings_value(&s, "poin"));
    settings_clear(&s);
    settings_clear(&s);
    CHECK(s.count == 0 && !s.text && !settings_value(&s, "a"));
}

/* A double is the same after the text and the reader of scenes. */
static void test_bits(void)
{
    const double value[] = {1.0 / 3, 5e4 + 1e-11, 1e-3, 123456.123456789, 0.1};
    struct settings s = {0};
    struct scene scene;
    struct discretization d;
    struct message why = {""};

    for (size_t n = 0; n < sizeof value / sizeof *value; n++) {
        settings_number(&s, "material.young", value[n]);
        settings_numbers(&s, "gravity", 3, (const double[]){0, value[n], -value[n]});
        if (!CHECK(read(&s, &scene, &d, &why) == STATUS_OK))
            printf("  %s\n", why.text), exit(1);
        CHECK(scene.young == value[n]);
        CHECK(scene.gravity[1] == value[n] && scene.gravity[2] == -value[n]);
        scene_clear(&scene);
        discretization_clear(&d);
    }
    settings_clear(&s);
}

/* Without memory at the n-th allocation nothing is read as if it had not been set. */
static void test_memory(void)
{
    for (int n = 0; n < 4; n++) {
        struct settings s = {0}, all = {0};
        struct scene scene;
        struct discretization d;
        struct message why = {""};
        left = n;
        settings_set(&s, "material.young=1e4");
        settings_number(&s, "material.density", 0.3);
        left = -1;
        if (n == 3) { /* it takes three: a copy and two places */
            CHECK(s.status == STATUS_OK && s.count == 2);
            settings_clear(&s);
            continue;
        }
        CHECK(s.status == STATUS_MEMORY && s.count < 2);
        settings_append(&all, &s);
        CHECK(all.status == STATUS_MEMORY);
        CHECK(read(&all, &scene, &d, &why) == STATUS_MEMORY && strstr(why.text, "memory"));
        settings_clear(&s);
        settings_clear(&all);
    }
}

int main(void)
{
    test_order();
    test_bits();
    test_memory();
    return check_result();
}
