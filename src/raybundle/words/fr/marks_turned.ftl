marks_turned = { $marks } mesures de { $table } ont été faites dans des photographies tournées par un logiciel ; elles sont retournées.

marks_turned-undecided = { $marks } mesures de { $table } proviennent peut-être de photographies affichées tournées ; elles sont inchangées.
