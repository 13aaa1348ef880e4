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

repeated_structure-missing = Wiederholte Strukturen: Zwei Gruppen von Aufnahmen liegen aufeinander und zeigen vielleicht verschiedene, ähnliche Teile.
    .why = Auf { PERCENT($after) } % ihrer gemeinsamen Fläche zeigt eine Aufnahme Punkte, die andere keine (Grenze { PERCENT($limit) } %): { LIST($first, most: 4) }; { LIST($second, most: 4) }.
    .do = Ihre Positionen mit den wirklichen Standpunkten vergleichen; Aufnahmen machen, die beide Teile zusammen zeigen, oder codierte Zielmarken anbringen.

repeated_structure-rearranged = Wiederholte Strukturen: Zwei Gruppen von Aufnahmen zeigen verschiedene, ähnliche Teile; sie sind neu angeordnet.
    .why = Aufeinander zeigt auf { PERCENT($before) } % der gemeinsamen Fläche eine Aufnahme Punkte, die andere keine (Grenze { PERCENT($limit) } %), neu angeordnet auf { PERCENT($after) } %: { LIST($first, most: 4) }; { LIST($second, most: 4) }.
    .do = Stehen sie in getrennten Teilen, Aufnahmen machen, die beide Teile zusammen zeigen.

repeated_structure-unsettled = Wiederholte Strukturen: { $pairs } Paare von Aufnahmen passen gut zusammen und widersprechen der Orientierung.
    .why = Anzahl der Teile: { $parts }; Aufnahmen ohne Orientierung: { $lost }. Aufnahmen können am falschen Teil des Objekts orientiert sein: { LIST($names, most: 4) }.
    .do = Ihre Positionen mit den wirklichen Standpunkten vergleichen; mit mehr Überdeckung aufnehmen oder codierte Zielmarken anbringen.
