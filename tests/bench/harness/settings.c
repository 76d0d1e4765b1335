/* Settings: in order, the last wins, numbers to the bit. */
#include "bench/harness/contestant.h"

#include "tests/run_fixture.h"

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
    CHECK(s.count == 7);
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
        REQUIRE_SAY(read(&s, &scene, &d, &why) == STATUS_OK, "%s", why.text);
        CHECK(scene.young == value[n]);
        CHECK(scene.gravity[1] == value[n] && scene.gravity[2] == -value[n]);
        scene_clear(&scene);
        discretization_clear(&d);
    }
    settings_clear(&s);
}

int main(void)
{
    test_order();
    test_bits();
    return check_result();
}
