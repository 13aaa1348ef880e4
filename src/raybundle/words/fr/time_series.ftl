time_series-one_surface = Les volumes dans le temps demandent au moins deux surfaces.

time_series-no_outline = Les volumes dans le temps demandent le contour d'une zone.

time_series-dates_not_paired = { $surfaces } surfaces ont { $dates } dates.

time_series-dates_not_ascending = Les dates ne sont pas croissantes : { LIST($dates, most: 6) }.
