contours-none = Il n'y a pas de courbe de niveau à un intervalle de { NUM($interval, digits: 6) }.

contours-interval_too_small = L'intervalle { $interval } { $unit } est inférieur à deux écarts-types d'altitude ({ NUM($sigma, digits: 2) } { $unit }).
