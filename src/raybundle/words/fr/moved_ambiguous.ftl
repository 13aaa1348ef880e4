moved_ambiguous = Le point { $point } est signalé comme déplacé ; { $others } peut l'être à sa place.

moved_ambiguous-other = Sans { $point } le reste concorde aussi bien (F { NUM($F, decimals: 2) }).
