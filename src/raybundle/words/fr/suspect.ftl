suspect-value = { $name } { $component } ({ observations-kind }) contredit les autres observations de { NUM($off, digits: 2) } { $unit }.

suspect-others = { LIST($names, most: 10) } peut être en cause au lieu de { $name } ; les observations ne permettent pas de trancher.

suspect-beside = Si { $name } est corrigé, le test ne rejette plus { LIST($names, most: 10) }.
