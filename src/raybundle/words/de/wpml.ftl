wpml-action_end = Eine Aktionsgruppe endet bei Wegpunkt { $way_point }; es gibt { $n }.
    .do = Den Flugplan neu exportieren.
