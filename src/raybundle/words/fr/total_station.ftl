total_station-vertical_sight = Série { $set } de directions.csv : { $station } et { $target } ont la même position en plan dans points.csv.
