/* Out of memory at the k-th allocation of the scene reader, for every k: the status says
 * so, nothing leaks (with the sanitizers), nothing is left behind. The linker sends this
 * project's allocations through the wrappers below; libyaml's own are not touched. */
#include "models/reader/scene_file.h"
#include "tests/check.h"

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
char *__real_strdup(const char *text);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
char *__wrap_strdup(const char *text);

static int allocations_left = -1; /* negative: no limit */

static bool fails(void)
{
    return allocations_left >= 0 && allocations_left-- == 0;
}

void *__wrap_malloc(size_t size)
{
    return fails() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    return fails() ? NULL : __real_realloc(old, size);
}

char *__wrap_strdup(const char *text)
{
    return fails() ? NULL : __real_strdup(text);
}

static enum status read_scene(int allocations, struct scene *scene, struct message *why)
{
    static const char *const settings[] = {
        "pose.u=[1,0,0]",
        "supports[0].path=[[0,0,0,0],[1,0,0,1]]",
        "loads=[{at: {u: 1}, force: [0,0,1]}]",
        "obstacles=[{sphere: {center: [0,0,0], radius: 1}}]",
        "discretization.knots_u=[0,0,1,1]",
        "discretization.weights=[1,1]"};
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    enum status st;

    allocations_left = allocations;
    st = scene_file_read(SOURCE_DIR "/models/scenes/moving_edge.yaml",
                         sizeof settings / sizeof *settings, settings, scene, &d, why);
    allocations_left = -1;
    discretization_clear(&d);
    return st;
}

int main(void)
{
    static const struct scene zero;
    struct scene scene;
    struct message why;
    int k = 0;

    while (read_scene(k, &scene, &why) != STATUS_OK) {
        REQUIRE(k++ < 10000);
        CHECK(!memcmp(&scene, &zero, sizeof zero));
        CHECK(strstr(why.text, status_text(STATUS_MEMORY)));
    }
    CHECK(k > 50); /* nodes, texts and arrays: the limit was at work */
    scene_clear(&scene);
    return check_result();
}
