# $shards = false
project_status-without_workers = { $shards ->
    [yes] CPU s and memory are
   *[no] Memory is
 } of the machine of the command, without workers.

# $state = "working"
# $stage = "matching"
# $done = 7
# $total = 12
# $at = "2026-05-01 12:00"
project_status-running = { $state ->
        [working] In work
        [stopped] Stopped
        *[waiting] Waiting for shards
    }: { $stage }, { $done } of { $total } done ({ $at }).

project_status-works = A run works in it now.

# $n = 12
# $done = 7
project_status-listed = Tasks for shards: { $n }, { $done } of them done.

# $size = "1.2 GB"
# $store = "none"
project_status-products = Products: { $size } in its folder{ $store ->
        [none] {""}
        *[other] , others in { $store }
    }.

# $folder = "facade-project/cache"
project_status-deletable = { $folder } may be deleted; the next run then measures everything again.

project_status-surface = Surface:

# $folder = "result.parts"
# $in_use = false
# $size = "1.2 GB"
# $n = 0
# $stores = []
project_status-parts = { $folder }: parts of { $in_use ->
        [yes] a running adjustment
        *[no] an interrupted adjustment
    } ({ $size }{ $n ->
        [0] {""}
        *[other] {" "}and in { $stores }
    }).
    .do = { $in_use ->
            [yes] {""}
            *[no] Continue with the same command, or delete the folder.
        }

project_status-begun = Project begun.

project_status-exported = Measurements exported.

# $seq = 3
# $verb = "undo"
# $of = 2
# $of_verb = "put"
# $arguments = ["image IMG_3.jpg", "point gate"]
project_status-action = Action { $seq }: { $verb }{ $of ->
        [0] {""}
        *[other] {" "}of action { $of }, { $of_verb } { LIST($arguments, most: 12) }
    }.
