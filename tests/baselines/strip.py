"""strip.py RESULT KEPT - a result without what differs between two runs of the same program: clocks,
threads, memory, and lists that no comparison reads. Keeps the text of few lines, so that a change of a
baseline can be read."""

import json
import sys

CLOCKS = ('seconds', 'memory_bytes', 'peak_memory_bytes')
UNREAD = ('area_mm2', 'depths', 'sampling_intervals', 'uncertainty', 'passes', 'assumptions', 'agreement')
MOST_FINDINGS = 50


def stripped(value, key=None):
    if isinstance(value, dict):
        out = {k: stripped(v, k) for k, v in value.items()
               if not (k in UNREAD and isinstance(v, (list, dict)))}
        return {k: 0 if k in CLOCKS else v for k, v in out.items()}
    if isinstance(value, list):
        if key == 'edges_mm':
            return [value[0], value[-1]] if value else []
        return [stripped(v) for v in value]
    return value


def main(source, target):
    with open(source, encoding='utf-8') as file:
        result = stripped(json.load(file))
    result['created'] = '2000-01-01T00:00:00Z'
    result['threads'] = 1
    for stage in result['stages']:
        deviation = stage.get('deviation', {})
        deviation.get('histogram', {}).setdefault('area_mm2', [])
        for kind in ('gouges', 'uncuts'):
            # What is left out would count as new.
            if len(deviation.get(kind, [])) > MOST_FINDINGS:
                sys.exit(f'{source}: {len(deviation[kind])} {kind}: choose a job with fewer')
    with open(target, 'w', encoding='utf-8') as file:
        json.dump(result, file, indent=1, ensure_ascii=False)
        file.write('\n')


main(*sys.argv[1:])
