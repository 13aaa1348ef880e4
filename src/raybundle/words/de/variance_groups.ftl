variance_groups = Jede von { $n } Beobachtungsgruppen hat einen eigenen Varianzfaktor.

variance_groups-unsettled = Beobachtungsgruppen widersprechen einander; ihre Varianzfaktoren konvergieren nicht.
    .why = Alle Gruppen haben einen gemeinsamen Faktor; Fehler einer Gruppe vergrößern alle Standardabweichungen.
    .do = Zuerst die widersprechenden Beobachtungen finden.

variance_groups-group = { observations-kind } ({ $group }): Standardabweichungen × { NUM($factor, digits: 3) } ({ $count } Werte, Redundanz { NUM($redundancy, digits: 3) })

variance_groups-as_given = { observations-kind } ({ $group }): Standardabweichungen wie angegeben ({ $count } Werte, Redundanz { NUM($redundancy, digits: 3) })
