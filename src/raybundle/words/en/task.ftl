# $n = 3
# $names = ["a", "b", "c"]
task-cycle = { $n } tasks depend on each other: { $names }.
    .do = For tasks of your own, remove one dependency; otherwise report this error to the developers.

# $n = 120
# $file_name = "facade/cache/tasks"
# $project = "facade"
task-shards_waiting = { $n } { $n ->
        [one] task waits
       *[other] tasks wait
     } for shards, in { $file_name }.
    .do = Run raybundle worker { OPTION("shard", "I/N") } { $project } for each I from 0 to N - 1, in any order, then the same command again.

# $detail = "Permission denied"
task-list_not_readable = The list of tasks cannot be read ({ $detail }).
    .do = Check the permissions of the file.

# $detail = "is empty"
task-list_damaged = The list of tasks is damaged ({ $detail }).
    .why = Nothing of it is done.
    .do = Run the command again that wrote it.

# $detail = "invalid JSON"
task-list_no_task = This line of the list is not a task ({ $detail }).
    .why = The list is damaged; nothing of it is done.
    .do = Run the command again that wrote it.

# $name = "'../x'"
task-list_no_key = { $name } is not a key of a product.
    .why = The list is damaged; nothing of it is done.
    .do = Run the command again that wrote it.

# $n = 10
# $needed = 12
task-list_count = The list has { $n } tasks; { $needed } were written.
    .why = The list is damaged; nothing of it is done.
    .do = Run the command again that wrote it.

task-list_checksum = The checksum of the list of tasks is wrong.
    .why = The list is damaged; nothing of it is done.
    .do = Run the command again that wrote it.

# $kind = "ValueError"
# $detail = "shapes do not match"
task-failed = A task ended with an internal error: { $kind } ({ $detail })

task-needs_failed = A product that this task needs cannot be computed:

task-process_died = The process of the task ended without a result.
    .why = Memory is probably short.
    .do = Use fewer { OPTION("jobs") }.

# $name = "img_07.jpg"
# $n = 3
# $log = "facade/cache/failed-tasks.log"
task-failed_repeatedly = { $name }: { $n } attempts failed.
    .do = See { $log }.
