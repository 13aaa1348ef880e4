time_series-one_surface = Volumes over time need two surfaces or more.
    .do = Give the folders of all dates, the earliest first.

time_series-no_outline = Volumes over time need the outline of a region.
    .do = Give { OPTION("outline", "FILE") }.

# $surfaces = 3
# $dates = 2
time_series-dates_not_paired = { $surfaces } surfaces have { $dates } { $dates ->
        [one] date
       *[other] dates
     }.
    .do = Give { OPTION("date", "YYYY-MM-DD") } once for each surface, in their order.

# $dates = ["2026-06-01", "2026-05-01"]
time_series-dates_not_ascending = Dates do not ascend: { LIST($dates, most: 6) }.
    .do = Give the surfaces in the order of their dates.
