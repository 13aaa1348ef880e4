# $way_point = 40
# $n = 20
wpml-action_end = An action group ends at way point { $way_point }; there are { $n }.
    .do = Export the flight plan again.
