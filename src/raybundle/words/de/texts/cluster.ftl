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
