time_series-one_surface = Volumen über die Zeit brauchen mindestens zwei Oberflächen.
    .do = Die Ordner aller Tage angeben, den frühesten zuerst.

time_series-no_outline = Volumen über die Zeit brauchen den Umriss eines Gebiets.
    .do = { OPTION("outline", "FILE") } angeben.

time_series-dates_not_paired = { $surfaces } Oberflächen haben { $dates } { $dates ->
        [one] Datum
       *[other] Daten
     }.
    .do = { OPTION("date", "YYYY-MM-DD") } einmal für jede Oberfläche angeben, in deren Reihenfolge.

time_series-dates_not_ascending = Die Daten steigen nicht an: { LIST($dates, most: 6) }.
    .do = Die Oberflächen in der Reihenfolge ihrer Daten angeben.
