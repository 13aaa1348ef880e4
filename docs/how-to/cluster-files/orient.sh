#!/bin/bash
status=5
for round in $(seq 16); do
  raybundle orient photos --out project --cluster shards && exit 0
  status=$?
  [ "$status" = 5 ] || exit "$status"
  sbatch --wait shards.sh project
done
exit "$status"
