repeated_structure = Wiederholte Strukturen: { PERCENT($before) } % der Zuordnungen widersprechen anderen (Grenze { PERCENT($limit) } %).
    .why = { $pairs ->
     [0] Kein Paar ist weggelassen.
     [one] Ein Paar von Aufnahmen ähnlicher Teile ist weggelassen: { LIST($names, most: 4) }.
     *[other] { $pairs } Paare von Aufnahmen ähnlicher Teile sind weggelassen: { LIST($names, most: 4) }.
    } Von den übrigen widersprechen { PERCENT($after) } %, was üblich ist.
    .do = Die Positionen der Aufnahmen mit ihren wirklichen Standpunkten vergleichen.

repeated_structure-ambiguous = Wiederholte Strukturen: { PERCENT($after) } % der Zuordnungen widersprechen anderen (Grenze { PERCENT($limit) } %).
    .why = { $pairs ->
     [0] Kein Paar ist weggelassen.
     [one] Ein Paar von Aufnahmen ähnlicher Teile ist weggelassen: { LIST($names, most: 4) } (vorher { PERCENT($before) } %).
     *[other] { $pairs } Paare von Aufnahmen ähnlicher Teile sind weggelassen: { LIST($names, most: 4) } (vorher { PERCENT($before) } %).
    } Aufnahmen können am falschen Teil des Objekts orientiert sein.
    .do = Die Positionen der Aufnahmen mit den wirklichen Standpunkten vergleichen; dichter aufnehmen oder codierte Zielmarken anbringen.

repeated_structure-groups = Wiederholte Strukturen: { $groups } Gruppen von Aufnahmen zeigen vielleicht verschiedene, ähnliche Teile.
    .why = Zwischen ihnen haben { PERCENT($barren) } % der gemeinsamen Fläche keinen gemeinsamen Punkt (Grenze { PERCENT($limit) } %{ $known ->
     [yes] , innerhalb der Gruppen { PERCENT($within) } %
     *[no] { "" }
    }).
    .do = Die Positionen der Aufnahmen mit den wirklichen Standpunkten vergleichen; Aufnahmen zwischen den Gruppen machen oder codierte Zielmarken anbringen.

repeated_structure-group = Gruppe von { $n } { $n ->
     [one] Aufnahme
     *[other] Aufnahmen
    }: { LIST($names, most: 4) }
