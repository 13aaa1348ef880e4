frames-too_few_points = { $first } und { $second }: { $n } gemeinsame Punkte; ein Vergleich braucht { $least }.
    .do = Mehr gemeinsame Punkte messen.

frames-covariance_singular = { $first } und { $second }: Die gemeinsame Kovarianzmatrix ist singulär.
    .why = Fehlerfrei festgehaltene Punkte lassen sich nicht vergleichen.
    .do = Den festgehaltenen Punkten Standardabweichungen geben, dann neu ausgleichen.
