#include "bench/sweep/sweep_slot.h"

#include "bench/experiment/plan_case.h"

struct work {
    const struct plan *plan;
    const struct sweep_folder *folder;
    const struct plan_case *c;
};

/* In the child. */
static enum status run(void *context, struct message *why)
{
    const struct work *w = context;
    char path[SWEEP_FOLDER_PATH];
    struct case_result result;
    const struct case_plan todo = {
        .path = w->c->path,
        .setting_count = w->c->settings.count,
        .settings = (const char *const *)w->c->settings.text,
        .model = w->c->contestant->name,
        .every = w->plan->look,
        .intersections = w->plan->intersections,
        .snapshots = w->plan->keep == PLAN_KEEP_SNAPSHOTS,
        .out = path,
    };

    sweep_folder_file(w->folder, w->c->number, "h5", path);
    return case_run(&todo, &result, why);
}

enum status sweep_slot_start(struct sweep_slot *slot, const struct plan *plan,
                             const struct sweep_folder *folder, long number,
                             struct message *why)
{
    struct plan_case c;
    enum status st;

    TRY(plan_case_open(plan, number, &c, why));
    slot->number = number;
    st = child_start(&slot->child, run,
                     &(struct work){.plan = plan, .folder = folder, .c = &c}, why);
    plan_case_clear(&c);
out:
    return st;
}
