/* Scenes from any bytes, for libFuzzer or from files (fuzz.h). Leading lines `--set
 * KEY=VALUE` of the input are settings, the rest is the scene file.
 *
 * Beyond crashes, leaks and undefined behaviour it stops at: a refusal without a printable
 * sentence or with something left in the scene; a scene whose text does not read again. */
#include "models/reader/scene_file.h"
#include "tests/fuzz.h"

enum { MAX_SETTINGS = 8 };

/* Cuts leading setting lines off *text; line breaks become ends of strings. */
static int take_settings(char **text, const char *end, const char *settings[MAX_SETTINGS])
{
    int count = 0;

    while (count < MAX_SETTINGS && end - *text > 6 && !memcmp(*text, "--set ", 6)) {
        char *stop = memchr(*text, '\n', (size_t)(end - *text));

        if (!stop)
            break;
        *stop = '\0';
        settings[count++] = *text + 6;
        *text = stop + 1;
    }
    return count;
}

static void check_refusal(const struct scene *scene, const struct message *why)
{
    static const struct scene zero;

    MUST(!memcmp(scene, &zero, sizeof zero));
    fuzz_check_sentence(why, strncmp(why->text, "--set ", 6) ? "fuzz:" : "--set ");
}

static void check_scene(const struct scene *scene)
{
    struct scene again;
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    struct message why;
    int end = 0;

    MUST(scene->thickness > 0 && scene->young > 0 && scene->poisson < 0.5);
    MUST(scene->step > 0 && scene->end >= scene->step);
    MUST(scene_gamma(scene) >= 0);
    for (int i = 0; i < scene->support_count; i++)
        MUST(scene->supports[i].fix && scene->supports[i].hi[2] <= 1);
    /* Settings stand in the text as comments, so that what is read may differ or be
     * refused, but the text is always YAML. */
    if (scene_file_parse("again", scene->text, strlen(scene->text), 0, NULL, &again, &d,
                         &why) != STATUS_OK)
        MUST(sscanf(why.text, "again:%*d: not YAML%n", &end) <= 0 && !end);
    scene_clear(&again);
    discretization_clear(&d);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *settings[MAX_SETTINGS];
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    struct scene scene;
    struct message why;
    char *copy = malloc(size + 1), *text = copy;
    int count;

    MUST(copy);
    if (size > 0)
        memcpy(copy, data, size);
    count = take_settings(&text, copy + size, settings);
    if (scene_file_parse("fuzz", text, (size_t)(copy + size - text), count, settings,
                         &scene, &d, &why) == STATUS_OK)
        check_scene(&scene);
    else
        check_refusal(&scene, &why);
    scene_clear(&scene);
    discretization_clear(&d);
    free(copy);
    return 0;
}
