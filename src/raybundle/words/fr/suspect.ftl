suspect-value = { $name } { $component } ({ observations-kind }) contredit les autres observations de { NUM($off, digits: 2) } { $unit }.

suspect-others = { LIST($names, most: 10) } peut être en cause à la place ; les observations ne permettent pas de trancher.

suspect-beside = Le test ne rejette { LIST($names, most: 10) } qu'en sa présence.
