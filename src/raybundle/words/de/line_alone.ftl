line_alone = { $n } { $n ->
        [one] Trajektorie hat
       *[other] Trajektorien haben
     } nur Zeilen einer Blickrichtung: { $ids }.
    .why = Verbesserungen von Position und Lage sind voneinander und von den Punkten schwach trennbar; sie beruhen auf Passpunkten und angegebenen Standardabweichungen.
    .do = Zeilen ergänzen, die um mehr als { $limit_deg }° voraus- oder zurückblicken, oder kreuzende Streifen oder Passpunkte.
