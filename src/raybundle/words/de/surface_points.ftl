surface_points-too_few = { $name }: { $n } Punkte haben Strahlen; eine Fläche braucht { $least }.
    .do = Ein Ergebnis mit mehr Objektpunkten angeben.
