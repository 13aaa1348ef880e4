contours-none = Il n'y a pas de courbe de niveau à un intervalle de { NUM($interval, digits: 6) }.
