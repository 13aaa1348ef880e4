studio_epochs-date = Tag

studio_epochs-against = Vergleich mit

studio_epochs-blink = Blinken
    .title = Die Fotos beider Tage abwechselnd zeigen

studio_epochs-larger = Pfeile

studio_epochs-stable = Stabile Punkte

studio_epochs-whole = Ganzes Bild

studio_epochs-picture = Entzerrte Fotos mit Verschiebungen. Pfeiltasten wechseln den Tag, das Rad vergrößert.

studio_epochs-moved_when = Verschiebungen seit dem ersten Tag, mit Standardabweichungen

studio_epochs-rows = Zeilen

studio_epochs-kind = { $kind ->
        [untested] nicht prüfbar
        [every] alle verschobenen
        *[moved] bewegt
    }

studio_epochs-count = { $n } { $n ->
        [one] Zeile
        *[other] Zeilen
    }, { $shown } gezeigt [{ $unit }]

studio_epochs-point = Punkt oder Bereich

studio_epochs-since = Bewegt seit

studio_epochs-verdict = { $verdict ->
        [untested] nicht prüfbar
        [moved_area] mit seinem Bereich
        [moved] bewegt
        *[not_significant] nicht signifikant
    }

studio_epochs-mean_of_uneven = Ihre Punkte haben sich ungleichmäßig verschoben. Die Kurve ist ihr Mittel.

studio_epochs-uneven = ungleichmäßig, { $least } bis { $largest }

studio_epochs-over_time = { $name }{ $n ->
        [0] {""}
        *[other] {" "}({ $n } Punkte)
    }: Verschiebung in ihrer Richtung, 95-%-Band

studio_epochs-choose = { $name } über die Zeit zeigen

studio_epochs-nothing_chosen = Einen Punkt im Bild oder in der Tabelle wählen.

studio_epochs-visit = In den Bildern zeigen

studio_epochs-at_date = { $from } bis { $to }: { $values }

studio_epochs-no_place = Keine Verschiebung am { $date }.

studio_epochs-rectifying = Die Fotos vom { $date } werden entzerrt ...

studio_epochs-no_picture = Kein Foto vom { $date } zeigt die Ebene der Punkte.

studio_epochs-legend = { $part ->
        [near] zum Betrachter
        [away] vom Betrachter weg
        [open] an diesem Tag nicht signifikant
        *[arrow] in der Bildebene
    }
