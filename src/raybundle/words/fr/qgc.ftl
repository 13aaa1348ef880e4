qgc-no_plan = Ce n'est pas un plan de QGroundControl.

qgc-complex_item = L'élément est un { $kind } ; seul QGroundControl le convertit.
