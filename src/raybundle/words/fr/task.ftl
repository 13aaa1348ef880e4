task-cycle = { $n } tâches dépendent les unes des autres : { $names }.

task-shards_waiting = { $n } tâches attendent des lots (shards), dans { $file_name }.

task-list_not_readable = La liste des tâches n'est pas lisible ({ $detail }).

task-list_damaged = La liste des tâches est endommagée ({ $detail }).

task-list_no_task = Cette ligne de la liste n'est pas une tâche ({ $detail }).

task-list_no_key = { $name } n'est pas une clé de produit.

task-list_count = La liste a { $n } tâches ; { $needed } ont été écrites.

task-list_checksum = La somme de contrôle de la liste des tâches est fausse.

task-failed = Une tâche s'est terminée par une erreur interne : { $kind } ({ $detail })

task-needs_failed = Un produit dont cette tâche a besoin ne peut pas être calculé :

task-process_died = Le processus de la tâche s'est terminé sans résultat.

task-failed_repeatedly = { $name } : { $n } essais ont échoué.
