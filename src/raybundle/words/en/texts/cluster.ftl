cluster-other_store = Another store is there.

cluster-no_store = No store is there.

cluster-store_read_only = It cannot be written there.

cluster-scheduler_silent = The scheduler does not answer any more.

# $seconds = 55.0
cluster-waiting = Waiting for up to { NUM($seconds, decimals: 0) } s more.

# $n = 2
# $rest = 6
cluster-workers_lost = { $n } { $n ->
        [one] worker
        *[other] workers
    } lost, { $rest } left.

# $n = 6
cluster-workers_found = { $n } { $n ->
        [one] worker is
        *[other] workers are
    } there; the work continues.

# $n = 0
cluster-no_fitting_worker = { $n ->
        [0] No worker is there.
        [one] The only worker there has another version.
        *[other] None of the { $n } workers there has this version.
    }

# $n = 120
# $final = true
cluster-tasks_done = { $n } { $n ->
        [one] task
        *[other] tasks
    } done { $final ->
        [yes] in all
        *[no] so far
    }.

cluster-waits_for_scheduler = Waiting for a scheduler:

# $folder = "/data/cluster"
# $seconds = 60.0
cluster-folder_awaited = The folder { $folder } does not exist; the command ends unless it appears within { $seconds } s.

# $n = 3
# $wanted = 8
cluster-workers_awaited = { $n } of { $wanted } workers are there.

# $needed_gb = 2.0
# $largest_gb = 0.0
cluster-memory_unknown = Some workers announce no memory; none is requested (option of dask worker: resources "memory=8e9").

# $needed_gb = 6.0
# $largest_gb = 2.0
cluster-memory_short = A task needs { NUM($needed_gb, decimals: 1) } GB; the largest worker announces { NUM($largest_gb, decimals: 1) } GB and gets it.
