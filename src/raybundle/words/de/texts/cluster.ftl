cluster-other_store = Dort liegt ein anderer Speicher.

cluster-no_store = Dort liegt kein Speicher.

cluster-store_read_only = Dort kann nicht geschrieben werden.

cluster-scheduler_silent = Der Scheduler antwortet nicht mehr.

cluster-waiting = Es wird noch bis zu { NUM($seconds, decimals: 0) } s gewartet.

cluster-workers_lost = { $n } Worker verloren, { $rest } übrig.

cluster-workers_found = { $n } Worker { $n ->
        [one] ist
        *[other] sind
    } da; die Arbeit geht weiter.

cluster-no_fitting_worker = { $n ->
        [0] Kein Worker ist da.
        [one] Der einzige Worker hat eine andere Version.
        *[other] Keiner der { $n } Worker hat diese Version.
    }

cluster-tasks_done = { $n } { $n ->
        [one] Aufgabe
        *[other] Aufgaben
    } erledigt, { $final ->
        [yes] insgesamt
        *[no] bisher
    }.

cluster-waits_for_scheduler = Warten auf einen Scheduler:

cluster-folder_awaited = Der Ordner { $folder } existiert nicht; der Befehl endet, wenn er nicht innerhalb von { $seconds } s erscheint.

cluster-workers_awaited = { $n } von { $wanted } Workern sind da.

cluster-memory_unknown = Manche Worker geben keinen Speicher an; keiner wird verlangt (Option von dask worker: resources "memory=8e9").

cluster-memory_short = Eine Aufgabe braucht { NUM($needed_gb, decimals: 1) } GB; der größte Worker gibt { NUM($largest_gb, decimals: 1) } GB an und bekommt sie.
