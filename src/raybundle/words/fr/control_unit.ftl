control_unit = Les altitudes des points d'appui semblent être en pieds ; aucun n'est utilisé.

control_unit-point = Le point { $point } semble être en { $millimetres ->
     [yes] millimètres, les autres en mètres
     *[no] mètres, les autres en millimètres
    }.
