state-faults = Noch nicht verwenden: { $n } { $n ->
        [one] Fehler ist
        *[other] Fehler sind
    } zu klären.

state-accuracy_not_kept = Die geforderte Genauigkeit ist nicht eingehalten.

state-heights_relative = Höhen sind relativ und geneigt: Die Passpunkte haben keine gemessenen Höhen.

state-fault_text = { $text }
