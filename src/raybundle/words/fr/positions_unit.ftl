positions_unit = Les altitudes des positions semblent être en pieds ; aucune position n'est utilisée.
