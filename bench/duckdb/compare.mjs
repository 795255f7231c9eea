// DuckDB beside foresee: loads, joins and updates of the scenes that bench_compare has exported.
//
//   node bench/duckdb/compare.mjs SCENES TABLE MODULES SECONDS
//
// SCENES: the folder of `bench_compare --export`; TABLE: its CSV file, to which rows are added; MODULES: the folder
// whose node_modules has @duckdb/node-api; SECONDS: a join that takes longer ends the method. bench/compare.sh calls it.
//
// One thread, tables in memory, processor time of the process; each method and scene in a process of its own. `build`
// copies a temporary table of the objects, `report` is one UPDATE from a table of reports, then comes one join more. The
// two tables are read from CSV files outside the clock. Fails if a join finds other
// pairs than foresee, before or after the reports.
import {spawnSync} from 'node:child_process'
import {appendFileSync, readFileSync, readdirSync, writeFileSync} from 'node:fs'
import {createRequire} from 'node:module'
import {join as path, resolve} from 'node:path'
import {fileURLToPath} from 'node:url'
import {joinOf, methods} from './joins.mjs'

const [scenes, table, modules, seconds, scene, method] = process.argv.slice(2)

const csv = (file) => {
  const [header, ...lines] = readFileSync(file, 'utf8').trim().split('\n').map((line) => line.split(','))
  return lines.map((line) => Object.fromEntries(header.map((name, i) => [name, line[i]])))
}

const processor = () => { const {user, system} = process.cpuUsage(); return (user + system) / 1e6 }

const resident = (name) => 1024 * Number(new RegExp(`${name}:\\s+(\\d+)`).exec(readFileSync('/proc/self/status', 'utf8'))[1])

// The sum of struct Answer in core_rivals.h: it does not depend on the order of the pairs.
function sumOf(a, b) {
  const wrap = (x) => BigInt.asUintN(64, x)
  let sum = 0n
  for (let i = 0; i < a.length; ++i) {
    const [low, high] = a[i] < b[i] ? [a[i], b[i]] : [b[i], a[i]]
    let mixed = wrap((BigInt(low) << 32n | BigInt(high)) * 0x9e3779b97f4a7c15n)
    mixed ^= mixed >> 29n
    sum += wrap(mixed * 0xbf58476d1ce4e5b9n)
  }
  return wrap(sum)
}

async function one() {
  const {DuckDBInstance} = createRequire(resolve(modules, 'package.json'))('@duckdb/node-api')
  const instance = await DuckDBInstance.create(':memory:', {threads: '1'})
  const db = await instance.connect()
  const file = (name) => path(scenes, scene, name)
  const [expected] = csv(file('expected.csv'))
  const discs = readFileSync(file('objects.csv'), 'utf8').startsWith('id,x,y,vx,vy,r')
  const sql = joinOf(method, expected.h, discs)
  const requireSame = async (pairs, sum, when) => {
    const found = (await db.runAndReadAll('SELECT a::INTEGER, b::INTEGER FROM pairs')).getColumns()
    const [a, b] = found.length ? found : [[], []]
    if (a.length !== Number(pairs) || sumOf(a, b) !== BigInt(sum))
      throw Error(`${scene}: ${method} finds ${a.length} pairs ${when}, foresee ${pairs}`)
  }
  const timed = async (text) => { const begin = processor(); await db.run(text); return processor() - begin }

  await db.run(`CREATE TABLE reports AS FROM read_csv('${file('reports.csv')}')`)
  await db.run(`CREATE TEMP TABLE source AS FROM read_csv('${file('objects.csv')}')`)
  writeFileSync('/proc/self/clear_refs', '5')
  const before = resident('VmRSS')
  const build = await timed('CREATE TABLE objects AS FROM source')
  const started = processor()
  const limit = setInterval(() => { if (processor() - started > Number(seconds)) db.interrupt() }, 100)
  const times = []
  try {
    do times.push(await timed(sql)); while (times.length < 4 && times[0] < 2)
  } catch (error) {
    if (!/interrupt/i.test(error.message)) throw error
  }
  clearInterval(limit)
  const memory = resident('VmHWM') - before
  const stopped = times.length === 0
  if (times.length > 1) times.shift()  // it has warmed up
  const middle = stopped ? '' : times.sort((a, b) => a - b)[times.length >> 1]
  if (!stopped) await requireSame(expected.pairs, expected.sum, 'before the reports')
  const [{n}] = (await db.runAndReadAll('SELECT count(*)::INTEGER AS n FROM reports')).getRowObjects()
  const report = await timed(`UPDATE objects SET x = r.x, y = r.y, vx = r.vx, vy = r.vy FROM reports r
                              WHERE r.id = objects.id`) / n
  let after = ''
  if (!stopped) {
    after = (await timed(sql)).toPrecision(6)
    await requireSame(expected.pairs_after, expected.sum_after, 'after the reports')
  }
  const objects = readFileSync(file('objects.csv'), 'utf8').trim().split('\n').length - 1
  appendFileSync(table, [scene, objects, method, build.toPrecision(6), middle && middle.toPrecision(6), stopped ? seconds : '',
                         report.toPrecision(6), after, memory, stopped ? '' : expected.pairs, stopped ? '' : 0].join() + '\n')
  const ours = csv(table).filter((row) => row.scene === scene && row.method.startsWith('foresee') && row.join_s)
  const ratios = ours.filter((row) => row.method !== 'foresee TPR-tree').map((row) => `${(middle / row.join_s).toPrecision(3)} times ${row.method}`)
  console.log(scene.padEnd(10), method.padEnd(24), stopped ? 'join too long' : `join ${(1e3 * middle).toFixed(3)} ms: ${ratios.join(', ')}`)
  process.exit(stopped ? 3 : 0)
}

function all() {
  const order = readdirSync(scenes).sort((a, b) => Number(a.split('-')[1] ?? 0) - Number(b.split('-')[1] ?? 0))
  for (const name of Object.keys(methods))
    for (const each of order) {
      const done = spawnSync(process.execPath, [fileURLToPath(import.meta.url), scenes, table, modules, seconds, each, name],
                             {stdio: 'inherit'})
      if (done.status === 3) break
      if (done.status !== 0) process.exit(1)
    }
}

await (method ? one() : all())
