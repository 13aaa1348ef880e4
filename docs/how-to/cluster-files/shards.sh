#!/bin/bash
#SBATCH --array=0-31
#SBATCH --cpus-per-task=4
#SBATCH --mem=8G
exec raybundle worker "$1" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --jobs "$SLURM_CPUS_PER_TASK"
