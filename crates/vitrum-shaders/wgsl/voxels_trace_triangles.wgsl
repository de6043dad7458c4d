struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: vec3<f32>,
member_15: vec3<f32>,
member_16: vec3<f32>,
member_17: vec3<f32>,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: f32,
}
struct type_21 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage, read_write> global_5: type_16;
@group(0) @binding(5)
var<storage, read_write> global_6: type_24;
fn function_() {
var phi_1009_: u32;
var phi_1277_: f32;
var phi_1323_: i32;
var phi_1325_: type_21;
var phi_1328_: type_20;
var phi_1330_: i32;
var phi_1332_: i32;
var phi_2421_: i32;
var phi_2424_: i32;
var phi_2422_: i32;
var phi_2425_: i32;
var phi_2455_: i32;
var phi_2458_: i32;
var phi_2456_: i32;
var phi_2459_: i32;
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_4091_: type_20;
var phi_4386_: i32;
var phi_4606_: type_20;
var phi_4978_: type_20;
var phi_4979_: type_20;
var phi_5032_: type_20;
var phi_5046_: type_20;
var local_7: i32;
var local_8: i32;
var phi_5491_: type_20;
var phi_5492_: type_20;
var phi_5472_: type_20;
var phi_5493_: type_20;
var local_9: i32;
var local_10: i32;
var phi_2809_: type_20;
var phi_5499_: type_21;
var phi_5500_: type_20;
var phi_5501_: i32;
var phi_5502_: type_21;
var phi_5503_: type_20;
var phi_5504_: i32;
var phi_5506_: type_21;
var phi_5507_: type_20;
var phi_5508_: i32;
var phi_5510_: bool;
var phi_5521_: type_21;
var phi_5522_: type_20;
var phi_5523_: i32;
var phi_5525_: bool;
var phi_5526_: bool;
var phi_5823_: type_20;
var phi_5824_: type_20;
var local_11: i32;
var local_12: i32;
var phi_6091_: type_20;
var phi_6379_: type_21;
var phi_6380_: type_20;
var phi_6386_: type_21;
var phi_6387_: type_20;
var phi_1639_: i32;
var phi_2253_: i32;
var phi_2392_: type_21;
var phi_2384_: bool;
var phi_2385_: bool;
var phi_2393_: type_21;
var phi_2394_: bool;
var phi_2401_: type_21;
var phi_2402_: type_20;
var phi_2403_: type_21;
var phi_2404_: type_20;
var phi_2406_: type_21;
var phi_2407_: type_20;
var phi_2408_: bool;
var phi_2412_: type_21;
var phi_2413_: type_20;
var phi_2414_: bool;
var phi_2418_: type_21;
var phi_2419_: type_20;
var phi_6389_: type_21;
var phi_6390_: type_20;
var phi_6391_: i32;
var phi_1326_: type_21;
var phi_1329_: type_20;
var phi_1331_: i32;
var phi_1333_: i32;
var local_13: i32;
var local_14: i32;
var phi_6397_: i32;
var local_15: type_21;
var local_16: type_21;
var local_17: type_21;
var local_18: type_21;
var local_19: type_20;
var local_20: type_20;
var local_21: type_20;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: type_20;
var local_44: type_20;
var local_45: type_20;
var local_46: type_20;
var local_47: type_20;
var local_48: type_20;
var local_49: type_20;
var local_50: type_20;
var local_51: type_20;
var local_52: type_20;
var local_53: type_20;
var local_54: f32;
let _e116 = global;
let _e120 = arrayLength((&global_3.member));
let _e122 = arrayLength((&global_4.member));
let _e129 = global_1.member.member;
if (_e116.x < _e129.member) {
if (_e116.y < _e129.member_1) {
let _e136 = (_e129.member * _e129.member_1);
let _e138 = ((_e116.y * _e129.member) + _e116.x);
let _e139 = bitcast<i32>(_e138);
let _e141 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e143 = select(_e141, _e139, (_e139 < _e141));
let _e149 = global_5.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e150 = (_e136 + _e138);
let _e151 = bitcast<i32>(_e150);
let _e153 = select(_e141, _e151, (_e151 < _e141));
let _e159 = global_5.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e161 = ((2u * _e136) + _e138);
let _e162 = bitcast<i32>(_e161);
let _e164 = select(_e141, _e162, (_e162 < _e141));
let _e170 = global_5.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e172 = ((3u * _e136) + _e138);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e141, _e173, (_e173 < _e141));
let _e181 = global_5.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((4u * _e136) + _e138);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e141, _e184, (_e184 < _e141));
let _e192 = global_5.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((5u * _e136) + _e138);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e141, _e195, (_e195 < _e141));
let _e203 = global_5.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((6u * _e136) + _e138);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e141, _e206, (_e206 < _e141));
let _e214 = global_5.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((7u * _e136) + _e138);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e141, _e217, (_e217 < _e141));
let _e225 = global_5.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((8u * _e136) + _e138);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e141, _e228, (_e228 < _e141));
let _e236 = global_5.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((9u * _e136) + _e138);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e141, _e239, (_e239 < _e141));
let _e247 = global_5.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((10u * _e136) + _e138);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e141, _e250, (_e250 < _e141));
let _e258 = global_5.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((11u * _e136) + _e138);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e141, _e261, (_e261 < _e141));
let _e269 = global_5.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((12u * _e136) + _e138);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e141, _e272, (_e272 < _e141));
let _e280 = global_5.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((13u * _e136) + _e138);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e141, _e283, (_e283 < _e141));
let _e291 = global_5.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((14u * _e136) + _e138);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e141, _e294, (_e294 < _e141));
let _e302 = global_5.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((15u * _e136) + _e138);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e141, _e305, (_e305 < _e141));
let _e313 = global_5.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((16u * _e136) + _e138);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e141, _e316, (_e316 < _e141));
let _e324 = global_5.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((17u * _e136) + _e138);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e141, _e327, (_e327 < _e141));
let _e335 = global_5.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((18u * _e136) + _e138);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e141, _e338, (_e338 < _e141));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((19u * _e136) + _e138);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e141, _e349, (_e349 < _e141));
let _e357 = global_5.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e359 = ((20u * _e136) + _e138);
let _e360 = bitcast<i32>(_e359);
let _e362 = select(_e141, _e360, (_e360 < _e141));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e370 = ((21u * _e136) + _e138);
let _e371 = bitcast<i32>(_e370);
let _e373 = select(_e141, _e371, (_e371 < _e141));
let _e379 = global_5.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e381 = ((22u * _e136) + _e138);
let _e382 = bitcast<i32>(_e381);
let _e384 = select(_e141, _e382, (_e382 < _e141));
let _e390 = global_5.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e392 = ((23u * _e136) + _e138);
let _e393 = bitcast<i32>(_e392);
let _e395 = select(_e141, _e393, (_e393 < _e141));
let _e401 = global_5.member[bitcast<u32>(select(0i, _e395, (_e395 > 0i)))];
let _e403 = ((24u * _e136) + _e138);
let _e404 = bitcast<i32>(_e403);
let _e406 = select(_e141, _e404, (_e404 < _e141));
let _e412 = global_5.member[bitcast<u32>(select(0i, _e406, (_e406 > 0i)))];
let _e414 = ((25u * _e136) + _e138);
let _e415 = bitcast<i32>(_e414);
let _e417 = select(_e141, _e415, (_e415 < _e141));
let _e423 = global_5.member[bitcast<u32>(select(0i, _e417, (_e417 > 0i)))];
let _e425 = ((26u * _e136) + _e138);
let _e426 = bitcast<i32>(_e425);
let _e428 = select(_e141, _e426, (_e426 < _e141));
let _e434 = global_5.member[bitcast<u32>(select(0i, _e428, (_e428 > 0i)))];
let _e436 = ((27u * _e136) + _e138);
let _e437 = bitcast<i32>(_e436);
let _e439 = select(_e141, _e437, (_e437 < _e141));
let _e445 = global_5.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e447 = ((28u * _e136) + _e138);
let _e448 = bitcast<i32>(_e447);
let _e450 = select(_e141, _e448, (_e448 < _e141));
let _e456 = global_5.member[bitcast<u32>(select(0i, _e450, (_e450 > 0i)))];
let _e458 = ((29u * _e136) + _e138);
let _e459 = bitcast<i32>(_e458);
let _e461 = select(_e141, _e459, (_e459 < _e141));
let _e467 = global_5.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e469 = ((30u * _e136) + _e138);
let _e470 = bitcast<i32>(_e469);
let _e472 = select(_e141, _e470, (_e470 < _e141));
let _e478 = global_5.member[bitcast<u32>(select(0i, _e472, (_e472 > 0i)))];
let _e480 = ((31u * _e136) + _e138);
let _e481 = bitcast<i32>(_e480);
let _e483 = select(_e141, _e481, (_e481 < _e141));
let _e489 = global_5.member[bitcast<u32>(select(0i, _e483, (_e483 > 0i)))];
let _e491 = ((32u * _e136) + _e138);
let _e492 = bitcast<i32>(_e491);
let _e494 = select(_e141, _e492, (_e492 < _e141));
let _e500 = global_5.member[bitcast<u32>(select(0i, _e494, (_e494 > 0i)))];
let _e502 = ((33u * _e136) + _e138);
let _e503 = bitcast<i32>(_e502);
let _e505 = select(_e141, _e503, (_e503 < _e141));
let _e511 = global_5.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e513 = ((34u * _e136) + _e138);
let _e514 = bitcast<i32>(_e513);
let _e516 = select(_e141, _e514, (_e514 < _e141));
let _e522 = global_5.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e524 = ((35u * _e136) + _e138);
let _e525 = bitcast<i32>(_e524);
let _e527 = select(_e141, _e525, (_e525 < _e141));
let _e533 = global_5.member[bitcast<u32>(select(0i, _e527, (_e527 > 0i)))];
let _e535 = ((36u * _e136) + _e138);
let _e536 = bitcast<i32>(_e535);
let _e538 = select(_e141, _e536, (_e536 < _e141));
let _e544 = global_5.member[bitcast<u32>(select(0i, _e538, (_e538 > 0i)))];
let _e546 = ((37u * _e136) + _e138);
let _e547 = bitcast<i32>(_e546);
let _e549 = select(_e141, _e547, (_e547 < _e141));
let _e555 = global_5.member[bitcast<u32>(select(0i, _e549, (_e549 > 0i)))];
let _e557 = ((38u * _e136) + _e138);
let _e558 = bitcast<i32>(_e557);
let _e560 = select(_e141, _e558, (_e558 < _e141));
let _e566 = global_5.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
let _e568 = ((39u * _e136) + _e138);
let _e569 = bitcast<i32>(_e568);
let _e571 = select(_e141, _e569, (_e569 < _e141));
let _e577 = global_5.member[bitcast<u32>(select(0i, _e571, (_e571 > 0i)))];
let _e579 = ((40u * _e136) + _e138);
let _e580 = bitcast<i32>(_e579);
let _e582 = select(_e141, _e580, (_e580 < _e141));
let _e588 = global_5.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e590 = ((41u * _e136) + _e138);
let _e591 = bitcast<i32>(_e590);
let _e593 = select(_e141, _e591, (_e591 < _e141));
let _e599 = global_5.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e601 = ((42u * _e136) + _e138);
let _e602 = bitcast<i32>(_e601);
let _e604 = select(_e141, _e602, (_e602 < _e141));
let _e610 = global_5.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e612 = ((43u * _e136) + _e138);
let _e613 = bitcast<i32>(_e612);
let _e615 = select(_e141, _e613, (_e613 < _e141));
let _e621 = global_5.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
if (_e324 == 0f) {
phi_1009_ = 3u;
} else {
phi_1009_ = select(0u, 1u, (_e324 == 4f));
}
let _e626 = phi_1009_;
if (_e626 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e635 = atomicLoad((&global_6.member[0u]));
if (_e635 == 0u) {
atomicStore((&global_6.member[0u]), ((_e129.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e129.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e626 > 1u) {
let _e654 = select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < -2147483600f)), 2147483647i, (_e335 > 2147483500f)), (_e335 == _e335));
let _e681 = select(0i, select(select(i32(_e610), i32(-2147483648), (_e610 < -2147483600f)), 2147483647i, (_e610 > 2147483500f)), (_e610 == _e610));
if (_e681 >= 0i) {
let _e684 = (_e681 * 19i);
let _e686 = (bitcast<i32>(_e120) - 1i);
let _e688 = select(_e686, _e684, (_e684 < _e686));
let _e694 = global_3.member[bitcast<u32>(select(0i, _e688, (_e688 > 0i)))];
let _e695 = (_e684 + 1i);
let _e697 = select(_e686, _e695, (_e695 < _e686));
let _e703 = global_3.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e704 = (_e684 + 2i);
let _e706 = select(_e686, _e704, (_e704 < _e686));
let _e712 = global_3.member[bitcast<u32>(select(0i, _e706, (_e706 > 0i)))];
let _e713 = (_e684 + 3i);
let _e715 = select(_e686, _e713, (_e713 < _e686));
let _e721 = global_3.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e722 = (_e684 + 4i);
let _e724 = select(_e686, _e722, (_e722 < _e686));
let _e730 = global_3.member[bitcast<u32>(select(0i, _e724, (_e724 > 0i)))];
let _e731 = (_e684 + 5i);
let _e733 = select(_e686, _e731, (_e731 < _e686));
let _e739 = global_3.member[bitcast<u32>(select(0i, _e733, (_e733 > 0i)))];
let _e740 = (_e721 - _e694);
let _e741 = (_e730 - _e703);
let _e742 = (_e739 - _e712);
let _e743 = (_e684 + 6i);
let _e745 = select(_e686, _e743, (_e743 < _e686));
let _e751 = global_3.member[bitcast<u32>(select(0i, _e745, (_e745 > 0i)))];
let _e752 = (_e684 + 7i);
let _e754 = select(_e686, _e752, (_e752 < _e686));
let _e760 = global_3.member[bitcast<u32>(select(0i, _e754, (_e754 > 0i)))];
let _e761 = (_e684 + 8i);
let _e763 = select(_e686, _e761, (_e761 < _e686));
let _e769 = global_3.member[bitcast<u32>(select(0i, _e763, (_e763 > 0i)))];
let _e770 = (_e751 - _e694);
let _e771 = (_e760 - _e703);
let _e772 = (_e769 - _e712);
let _e775 = ((_e741 * _e772) - (_e742 * _e771));
let _e778 = ((_e742 * _e770) - (_e740 * _e772));
let _e781 = ((_e740 * _e771) - (_e741 * _e770));
let _e786 = (((_e775 * _e775) + (_e778 * _e778)) + (_e781 * _e781));
let _e789 = sqrt(select(0f, _e786, (_e786 > 0f)));
let _e792 = (1f / select(1e-20f, _e789, (_e789 > 1e-20f)));
phi_1277_ = (((_e181 * (_e775 * _e792)) + (_e192 * (_e778 * _e792))) + (_e203 * (_e781 * _e792)));
} else {
phi_1277_ = 1f;
}
let _e802 = phi_1277_;
let _e819 = bitcast<f32>((bitcast<u32>(_e802) & 2147483647u));
let _e823 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e654 == 16i) {
phi_1323_ = 0i;
} else {
phi_1323_ = -(_e654);
}
let _e828 = phi_1323_;
phi_1325_ = type_21(select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < -2147483600f)), 2147483647i, (_e280 > 2147483500f)), (_e280 == _e280)), select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < -2147483600f)), 2147483647i, (_e291 > 2147483500f)), (_e291 == _e291)), _e302, _e313, select(1e-3f, _e819, (_e819 > 1e-3f)));
phi_1328_ = type_20(vec3<f32>(_e149, _e159, _e170), vec3<f32>(_e181, _e192, _e203), vec3<f32>(_e214, _e225, _e236), vec3<f32>(_e247, _e258, _e269), vec3<f32>(_e280, _e291, _e302), _e313, _e324, _e654, _e346, _e357, _e368, _e379, vec3<f32>(_e390, _e401, _e412), vec3<f32>(_e423, _e434, _e445), vec3<f32>(_e456, _e467, _e478), vec3<f32>(_e489, _e500, _e511), vec3<f32>(_e522, _e533, _e544), vec3<f32>(_e555, _e566, _e577), select(0i, select(select(i32(_e588), i32(-2147483648), (_e588 < -2147483600f)), 2147483647i, (_e588 > 2147483500f)), (_e588 == _e588)), select(0i, select(select(i32(_e599), i32(-2147483648), (_e599 < -2147483600f)), 2147483647i, (_e599 > 2147483500f)), (_e599 == _e599)), _e681, _e621);
phi_1330_ = 0i;
phi_1332_ = _e828;
loop {
let _e830 = phi_1325_;
let _e832 = phi_1328_;
let _e834 = phi_1330_;
let _e836 = phi_1332_;
local_13 = _e836;
local_14 = _e836;
local_15 = _e830;
local_16 = _e830;
local_17 = _e830;
local_18 = _e830;
local_19 = _e832;
local_20 = _e832;
local_21 = _e832;
local_22 = _e832;
local_23 = _e832;
local_24 = _e832;
local_25 = _e832;
local_26 = _e832;
local_27 = _e832;
local_28 = _e832;
local_29 = _e832;
local_30 = _e832;
local_31 = _e832;
local_32 = _e832;
local_33 = _e832;
local_34 = _e832;
local_35 = _e832;
local_36 = _e832;
local_37 = _e832;
local_38 = _e832;
local_39 = _e832;
local_40 = _e832;
local_41 = _e832;
local_42 = _e832;
local_43 = _e832;
local_44 = _e832;
local_45 = _e832;
local_46 = _e832;
local_47 = _e832;
local_48 = _e832;
local_49 = _e832;
local_50 = _e832;
local_51 = _e832;
local_52 = _e832;
local_53 = _e832;
let _e840 = ((_e834 < 1024i) && (_e832.member_6 == 0f));
local_54 = _e832.member_6;
if _e840 {
if (_e832.member_19 < (_e823 / 8i)) {
let _e3801 = global_1.member.member_13;
let _e3803 = (_e832.member_20 >= 0i);
let _e3808 = (_e832.member_21 + select(0f, (_e3801 / _e830.member_4), _e3803));
let _e3816 = (_e832.member_19 * 8i);
let _e3824 = (1f / select(_e832.member_1.x, select(1e-12f, -1e-12f, (_e832.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e832.member_1.x) & 2147483647u)) < 1e-12f)));
let _e3832 = (1f / select(_e832.member_1.y, select(1e-12f, -1e-12f, (_e832.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e832.member_1.y) & 2147483647u)) < 1e-12f)));
let _e3840 = (1f / select(_e832.member_1.z, select(1e-12f, -1e-12f, (_e832.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e832.member_1.z) & 2147483647u)) < 1e-12f)));
let _e3842 = (_e823 - 1i);
let _e3844 = select(_e3842, _e3816, (_e3816 < _e3842));
let _e3850 = global_2.member[bitcast<u32>(select(0i, _e3844, (_e3844 > 0i)))];
let _e3851 = (_e3816 + 1i);
let _e3853 = select(_e3842, _e3851, (_e3851 < _e3842));
let _e3859 = global_2.member[bitcast<u32>(select(0i, _e3853, (_e3853 > 0i)))];
let _e3860 = (_e3816 + 2i);
let _e3862 = select(_e3842, _e3860, (_e3860 < _e3842));
let _e3868 = global_2.member[bitcast<u32>(select(0i, _e3862, (_e3862 > 0i)))];
let _e3869 = (_e3816 + 3i);
let _e3871 = select(_e3842, _e3869, (_e3869 < _e3842));
let _e3877 = global_2.member[bitcast<u32>(select(0i, _e3871, (_e3871 > 0i)))];
let _e3878 = (_e3816 + 4i);
let _e3880 = select(_e3842, _e3878, (_e3878 < _e3842));
let _e3886 = global_2.member[bitcast<u32>(select(0i, _e3880, (_e3880 > 0i)))];
let _e3887 = (_e3816 + 5i);
let _e3889 = select(_e3842, _e3887, (_e3887 < _e3842));
let _e3895 = global_2.member[bitcast<u32>(select(0i, _e3889, (_e3889 > 0i)))];
let _e3898 = ((_e3850 - _e832.member.x) * _e3824);
let _e3900 = ((_e3877 - _e832.member.x) * _e3824);
let _e3903 = ((_e3859 - _e832.member.y) * _e3832);
let _e3905 = ((_e3886 - _e832.member.y) * _e3832);
let _e3908 = ((_e3868 - _e832.member.z) * _e3840);
let _e3910 = ((_e3895 - _e832.member.z) * _e3840);
let _e3912 = select(_e3900, _e3898, (_e3898 < _e3900));
let _e3914 = select(_e3905, _e3903, (_e3903 < _e3905));
let _e3916 = select(_e3914, _e3912, (_e3912 > _e3914));
let _e3918 = select(_e3910, _e3908, (_e3908 < _e3910));
let _e3922 = select(_e3900, _e3898, (_e3898 > _e3900));
let _e3924 = select(_e3905, _e3903, (_e3903 > _e3905));
let _e3926 = select(_e3924, _e3922, (_e3922 < _e3924));
let _e3928 = select(_e3910, _e3908, (_e3908 > _e3910));
let _e3930 = select(_e3928, _e3926, (_e3926 < _e3928));
let _e3935 = ((select(_e3918, _e3916, (_e3916 > _e3918)) <= select(_e3808, _e3930, (_e3930 < _e3808))) && (_e3930 >= _e830.member_2));
let _e3936 = (_e3816 + 6i);
let _e3938 = select(_e3842, _e3936, (_e3936 < _e3842));
let _e3944 = global_2.member[bitcast<u32>(select(0i, _e3938, (_e3938 > 0i)))];
if _e3935 {
phi_1639_ = (_e832.member_19 + 1i);
} else {
let _e3952 = (_e3816 + 7i);
let _e3954 = select(_e3842, _e3952, (_e3952 < _e3842));
let _e3960 = global_2.member[bitcast<u32>(select(0i, _e3954, (_e3954 > 0i)))];
phi_1639_ = select(0i, select(select(i32(_e3960), i32(-2147483648), (_e3960 < -2147483600f)), 2147483647i, (_e3960 > 2147483500f)), (_e3960 == _e3960));
}
let _e3970 = phi_1639_;
let _e3992 = type_20(_e832.member, _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, _e832.member_6, _e832.member_7, _e832.member_8, _e832.member_9, _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e3970, _e832.member_20, _e832.member_21);
let _e3993 = select(-1i, select(0i, select(select(i32(_e3944), i32(-2147483648), (_e3944 < -2147483600f)), 2147483647i, (_e3944 > 2147483500f)), (_e3944 == _e3944)), _e3935);
if (_e3993 < 0i) {
phi_2412_ = type_21();
phi_2413_ = type_20();
phi_2414_ = true;
} else {
let _e3999 = bitcast<f32>((bitcast<u32>(_e832.member_1.x) & 2147483647u));
let _e4003 = bitcast<f32>((bitcast<u32>(_e832.member_1.y) & 2147483647u));
let _e4007 = bitcast<f32>((bitcast<u32>(_e832.member_1.z) & 2147483647u));
let _e4010 = ((_e3999 >= _e4003) && (_e3999 >= _e4007));
let _e4013 = (!(_e4010) && (_e4003 >= _e4007));
let _e4020 = (1f / select(select(_e832.member_1.z, _e832.member_1.y, _e4013), _e832.member_1.x, _e4010));
let _e4021 = (select(select(_e832.member_1.x, _e832.member_1.z, _e4013), _e832.member_1.y, _e4010) * _e4020);
let _e4022 = (select(select(_e832.member_1.y, _e832.member_1.x, _e4013), _e832.member_1.z, _e4010) * _e4020);
let _e4023 = (_e3993 * 19i);
let _e4025 = (bitcast<i32>(_e120) - 1i);
let _e4027 = select(_e4025, _e4023, (_e4023 < _e4025));
let _e4033 = global_3.member[bitcast<u32>(select(0i, _e4027, (_e4027 > 0i)))];
let _e4034 = (_e4023 + 1i);
let _e4036 = select(_e4025, _e4034, (_e4034 < _e4025));
let _e4042 = global_3.member[bitcast<u32>(select(0i, _e4036, (_e4036 > 0i)))];
let _e4043 = (_e4023 + 2i);
let _e4045 = select(_e4025, _e4043, (_e4043 < _e4025));
let _e4051 = global_3.member[bitcast<u32>(select(0i, _e4045, (_e4045 > 0i)))];
let _e4052 = (_e4033 - _e832.member.x);
let _e4053 = (_e4042 - _e832.member.y);
let _e4054 = (_e4051 - _e832.member.z);
let _e4060 = select(select(_e4054, _e4053, _e4013), _e4052, _e4010);
let _e4062 = (select(select(_e4052, _e4054, _e4013), _e4053, _e4010) - (_e4021 * _e4060));
let _e4064 = (select(select(_e4053, _e4052, _e4013), _e4054, _e4010) - (_e4022 * _e4060));
let _e4066 = (_e4023 + 3i);
let _e4068 = select(_e4025, _e4066, (_e4066 < _e4025));
let _e4074 = global_3.member[bitcast<u32>(select(0i, _e4068, (_e4068 > 0i)))];
let _e4075 = (_e4023 + 4i);
let _e4077 = select(_e4025, _e4075, (_e4075 < _e4025));
let _e4083 = global_3.member[bitcast<u32>(select(0i, _e4077, (_e4077 > 0i)))];
let _e4084 = (_e4023 + 5i);
let _e4086 = select(_e4025, _e4084, (_e4084 < _e4025));
let _e4092 = global_3.member[bitcast<u32>(select(0i, _e4086, (_e4086 > 0i)))];
let _e4093 = (_e4074 - _e832.member.x);
let _e4094 = (_e4083 - _e832.member.y);
let _e4095 = (_e4092 - _e832.member.z);
let _e4101 = select(select(_e4095, _e4094, _e4013), _e4093, _e4010);
let _e4103 = (select(select(_e4093, _e4095, _e4013), _e4094, _e4010) - (_e4021 * _e4101));
let _e4105 = (select(select(_e4094, _e4093, _e4013), _e4095, _e4010) - (_e4022 * _e4101));
let _e4107 = (_e4023 + 6i);
let _e4109 = select(_e4025, _e4107, (_e4107 < _e4025));
let _e4115 = global_3.member[bitcast<u32>(select(0i, _e4109, (_e4109 > 0i)))];
let _e4116 = (_e4023 + 7i);
let _e4118 = select(_e4025, _e4116, (_e4116 < _e4025));
let _e4124 = global_3.member[bitcast<u32>(select(0i, _e4118, (_e4118 > 0i)))];
let _e4125 = (_e4023 + 8i);
let _e4127 = select(_e4025, _e4125, (_e4125 < _e4025));
let _e4133 = global_3.member[bitcast<u32>(select(0i, _e4127, (_e4127 > 0i)))];
let _e4134 = (_e4115 - _e832.member.x);
let _e4135 = (_e4124 - _e832.member.y);
let _e4136 = (_e4133 - _e832.member.z);
let _e4142 = select(select(_e4136, _e4135, _e4013), _e4134, _e4010);
let _e4144 = (select(select(_e4134, _e4136, _e4013), _e4135, _e4010) - (_e4021 * _e4142));
let _e4146 = (select(select(_e4135, _e4134, _e4013), _e4136, _e4010) - (_e4022 * _e4142));
let _e4150 = ((_e4144 * _e4105) - (_e4146 * _e4103));
let _e4153 = ((_e4062 * _e4146) - (_e4064 * _e4144));
let _e4156 = ((_e4103 * _e4064) - (_e4105 * _e4062));
let _e4158 = ((_e4150 + _e4153) + _e4156);
let _e4172 = (!(((((_e4150 < 0f) || (_e4153 < 0f)) || (_e4156 < 0f)) && (((_e4150 > 0f) || (_e4153 > 0f)) || (_e4156 > 0f)))) && (_e4158 != 0f));
let _e4180 = select(1e30f, ((((_e4150 * (_e4060 * _e4020)) + (_e4153 * (_e4101 * _e4020))) + (_e4156 * (_e4142 * _e4020))) / select(1f, _e4158, _e4172)), _e4172);
if (_e4180 >= _e3808) {
phi_2406_ = type_21();
phi_2407_ = type_20();
phi_2408_ = true;
} else {
let _e4182 = (_e4074 - _e4033);
let _e4183 = (_e4083 - _e4042);
let _e4184 = (_e4092 - _e4051);
let _e4185 = (_e4115 - _e4033);
let _e4186 = (_e4124 - _e4042);
let _e4187 = (_e4133 - _e4051);
let _e4190 = ((_e4183 * _e4187) - (_e4184 * _e4186));
let _e4193 = ((_e4184 * _e4185) - (_e4182 * _e4187));
let _e4196 = ((_e4182 * _e4186) - (_e4183 * _e4185));
let _e4201 = (((_e4190 * _e4190) + (_e4193 * _e4193)) + (_e4196 * _e4196));
let _e4204 = sqrt(select(0f, _e4201, (_e4201 > 0f)));
let _e4207 = (1f / select(1e-20f, _e4204, (_e4204 > 1e-20f)));
let _e4215 = (((_e832.member_1.x * (_e4190 * _e4207)) + (_e832.member_1.y * (_e4193 * _e4207))) + (_e832.member_1.z * (_e4196 * _e4207)));
let _e4218 = bitcast<f32>((bitcast<u32>(_e4215) & 2147483647u));
let _e4220 = select(1e-3f, _e4218, (_e4218 > 1e-3f));
let _e4221 = (_e4023 + 18i);
let _e4223 = select(_e4025, _e4221, (_e4221 < _e4025));
let _e4229 = global_3.member[bitcast<u32>(select(0i, _e4223, (_e4223 > 0i)))];
let _e4236 = select(0i, select(select(i32(_e4229), i32(-2147483648), (_e4229 < -2147483600f)), 2147483647i, (_e4229 > 2147483500f)), (_e4229 == _e4229));
let _e4237 = (_e4236 * 4i);
let _e4239 = (bitcast<i32>(_e122) - 1i);
let _e4241 = select(_e4239, _e4237, (_e4237 < _e4239));
let _e4247 = global_4.member[bitcast<u32>(select(0i, _e4241, (_e4241 > 0i)))];
let _e4250 = (select(_e4247, 1f, (_e4236 == 16i)) == 0f);
if _e4250 {
phi_2253_ = 0i;
} else {
phi_2253_ = (1i << bitcast<u32>((_e4236 & 31i)));
}
let _e4255 = phi_2253_;
let _e4256 = (_e4215 < 0f);
let _e4257 = select(_e4255, 0i, _e4256);
let _e4258 = select(0i, _e4255, _e4256);
let _e4266 = (_e4180 * _e4220);
let _e4279 = (((_e4180 > _e830.member_2) && (_e830.member_2 > 0f)) || (((_e4266 > (_e3801 * 2f)) || (((_e4250 || ((_e4258 & ~(_e836)) != 0i)) || ((_e4257 & _e836) != 0i)) && (_e4266 >= -((_e3801 * 0.5f))))) && (_e830.member_2 <= 0f)));
if _e4279 {
let _e4280 = (_e4180 < _e832.member_21);
if (_e3803 && ((bitcast<f32>((bitcast<u32>((_e4180 - _e832.member_21)) & 2147483647u)) * select(_e830.member_4, _e4220, (_e4220 > _e830.member_4))) <= _e3801)) {
let _e4313 = type_21((_e830.member | _e4258), _e830.member_1, _e830.member_2, _e830.member_3, _e830.member_4);
let _e4320 = type_21(_e4313.member, (_e830.member_1 | _e4257), _e4313.member_2, _e4313.member_3, _e4313.member_4);
let _e4330 = ((_e832.member_20 * 19i) + 18i);
let _e4332 = select(_e4025, _e4330, (_e4330 < _e4025));
let _e4338 = global_3.member[bitcast<u32>(select(0i, _e4332, (_e4332 > 0i)))];
let _e4345 = select(0i, select(select(i32(_e4338), i32(-2147483648), (_e4338 < -2147483600f)), 2147483647i, (_e4338 > 2147483500f)), (_e4338 == _e4338));
let _e4346 = (_e4345 * 4i);
let _e4348 = select(_e4239, _e4346, (_e4346 < _e4239));
let _e4354 = global_4.member[bitcast<u32>(select(0i, _e4348, (_e4348 > 0i)))];
if (_e4250 != (select(_e4354, 1f, (_e4345 == 16i)) == 0f)) {
phi_2385_ = _e4250;
} else {
if (!(_e4250) && (_e4236 != _e4345)) {
phi_2384_ = (_e4236 < _e4345);
} else {
phi_2384_ = _e4280;
}
let _e4364 = phi_2384_;
phi_2385_ = _e4364;
}
let _e4366 = phi_2385_;
phi_2393_ = type_21(_e4320.member, _e4320.member_1, _e4320.member_2, select(_e4180, _e830.member_3, (_e830.member_3 > _e4180)), _e4320.member_4);
phi_2394_ = _e4366;
} else {
if _e4280 {
let _e4294 = type_21(_e4258, _e830.member_1, _e830.member_2, _e830.member_3, _e830.member_4);
let _e4299 = type_21(_e4294.member, _e4257, _e4294.member_2, _e4294.member_3, _e4294.member_4);
phi_2392_ = type_21(_e4299.member, _e4299.member_1, _e4299.member_2, _e4180, _e4299.member_4);
} else {
phi_2392_ = _e830;
}
let _e4306 = phi_2392_;
phi_2393_ = _e4306;
phi_2394_ = _e4280;
}
let _e4368 = phi_2393_;
let _e4370 = phi_2394_;
if _e4370 {
let _e4392 = type_20(_e3992.member, _e3992.member_1, _e3992.member_2, _e3992.member_3, _e3992.member_4, _e3992.member_5, _e3992.member_6, _e3992.member_7, _e3992.member_8, _e3992.member_9, _e3992.member_10, _e3992.member_11, _e3992.member_12, _e3992.member_13, _e3992.member_14, _e3992.member_15, _e3992.member_16, _e3992.member_17, _e3992.member_18, _e3992.member_19, _e3993, _e3992.member_21);
phi_2401_ = type_21(_e4368.member, _e4368.member_1, _e4368.member_2, _e4368.member_3, _e4220);
phi_2402_ = type_20(_e4392.member, _e4392.member_1, _e4392.member_2, _e4392.member_3, _e4392.member_4, _e4392.member_5, _e4392.member_6, _e4392.member_7, _e4392.member_8, _e4392.member_9, _e4392.member_10, _e4392.member_11, _e4392.member_12, _e4392.member_13, _e4392.member_14, _e4392.member_15, _e4392.member_16, _e4392.member_17, _e4392.member_18, _e4392.member_19, _e4392.member_20, _e4180);
} else {
phi_2401_ = _e4368;
phi_2402_ = _e3992;
}
let _e4421 = phi_2401_;
let _e4423 = phi_2402_;
phi_2403_ = _e4421;
phi_2404_ = _e4423;
} else {
phi_2403_ = type_21();
phi_2404_ = type_20();
}
let _e4425 = phi_2403_;
let _e4427 = phi_2404_;
phi_2406_ = _e4425;
phi_2407_ = _e4427;
phi_2408_ = select(true, false, _e4279);
}
let _e4430 = phi_2406_;
let _e4432 = phi_2407_;
let _e4434 = phi_2408_;
phi_2412_ = _e4430;
phi_2413_ = _e4432;
phi_2414_ = _e4434;
}
let _e4436 = phi_2412_;
let _e4438 = phi_2413_;
let _e4440 = phi_2414_;
if _e4440 {
phi_2418_ = _e830;
phi_2419_ = _e3992;
} else {
phi_2418_ = _e4436;
phi_2419_ = _e4438;
}
let _e4442 = phi_2418_;
let _e4444 = phi_2419_;
phi_6389_ = _e4442;
phi_6390_ = _e4444;
phi_6391_ = _e836;
} else {
phi_2421_ = 15i;
phi_2424_ = 16i;
loop {
let _e845 = phi_2421_;
let _e847 = phi_2424_;
local = _e847;
local_1 = _e847;
local_3 = _e847;
local_6 = _e847;
local_7 = _e847;
local_9 = _e847;
local_10 = _e847;
local_11 = _e847;
local_12 = _e847;
let _e848 = (_e845 >= 0i);
if _e848 {
phi_2422_ = (_e845 - 1i);
phi_2425_ = select(_e847, _e845, (((_e836 >> bitcast<u32>((_e845 & 31i))) & 1i) == 1i));
} else {
phi_2422_ = i32();
phi_2425_ = i32();
}
let _e857 = phi_2422_;
let _e859 = phi_2425_;
continue;
continuing {
phi_2421_ = _e857;
phi_2424_ = _e859;
break if !(_e848);
}
}
let _e862 = (_e832.member_20 >= 0i);
let _e871 = ((_e836 | (_e830.member & ~(_e830.member_1))) & ~((_e830.member_1 & ~(_e830.member))));
phi_2455_ = 15i;
phi_2458_ = 16i;
loop {
let _e873 = phi_2455_;
let _e875 = phi_2458_;
local_2 = _e875;
local_4 = _e875;
local_5 = _e875;
local_8 = _e875;
let _e876 = (_e873 >= 0i);
if _e876 {
phi_2456_ = (_e873 - 1i);
phi_2459_ = select(_e875, _e873, (((_e871 >> bitcast<u32>((_e873 & 31i))) & 1i) == 1i));
} else {
phi_2456_ = i32();
phi_2459_ = i32();
}
let _e885 = phi_2456_;
let _e887 = phi_2459_;
continue;
continuing {
phi_2455_ = _e885;
phi_2458_ = _e887;
break if !(_e876);
}
}
let _e890 = (_e832.member_20 == -1i);
let _e892 = local;
let _e893 = (_e892 == 16i);
let _e895 = (!(_e862) && (_e890 || _e893));
if _e862 {
let _e897 = (_e832.member_20 * 19i);
let _e898 = (_e897 + 18i);
let _e900 = (bitcast<i32>(_e120) - 1i);
let _e902 = select(_e900, _e898, (_e898 < _e900));
let _e908 = global_3.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e915 = select(0i, select(select(i32(_e908), i32(-2147483648), (_e908 < -2147483600f)), 2147483647i, (_e908 > 2147483500f)), (_e908 == _e908));
let _e916 = (_e915 * 4i);
let _e918 = (bitcast<i32>(_e122) - 1i);
let _e920 = select(_e918, _e916, (_e916 < _e918));
let _e926 = global_4.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e929 = (select(_e926, 1f, (_e915 == 16i)) == 0f);
if _e895 {
phi_5506_ = type_21();
phi_5507_ = type_20();
phi_5508_ = i32();
phi_5510_ = false;
} else {
if _e929 {
phi_5502_ = type_21();
phi_5503_ = type_20();
phi_5504_ = i32();
} else {
let _e931 = local_1;
let _e933 = local_2;
if (_e931 == _e933) {
let _e2816 = (_e830.member_3 - _e830.member_2);
let _e2818 = select(0f, _e2816, (_e2816 > 0f));
let _e2820 = local_9;
if (_e2820 != 16i) {
let _e2845 = type_20(_e832.member, _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, _e832.member_6, _e832.member_7, _e832.member_8, (_e832.member_9 + _e2818), _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e832.member_19, _e832.member_20, _e832.member_21);
let _e2847 = local_10;
let _e2848 = (_e2847 * 4i);
let _e2849 = (_e2848 + 1i);
let _e2851 = select(_e918, _e2849, (_e2849 < _e918));
let _e2857 = global_4.member[bitcast<u32>(select(0i, _e2851, (_e2851 > 0i)))];
let _e2859 = -((_e2857 * _e2818));
let _e2861 = select(-87f, _e2859, (_e2859 > -87f));
let _e2863 = select(88f, _e2861, (_e2861 < 88f));
let _e2865 = ((_e2863 * 1.442695f) + 0.5f);
let _e2867 = select(-127f, _e2865, (_e2865 > -127f));
let _e2869 = select(128f, _e2867, (_e2867 < 128f));
let _e2876 = select(0i, select(select(i32(_e2869), i32(-2147483648), (_e2869 < -2147483600f)), 2147483647i, (_e2869 > 2147483500f)), (_e2869 == _e2869));
let _e2880 = (_e2876 - select(0i, 1i, (_e2869 < f32(_e2876))));
let _e2881 = f32(_e2880);
let _e2885 = ((_e2863 - (_e2881 * 0.6933594f)) - (_e2881 * -2.1219444e-4f));
let _e2906 = (_e2848 + 2i);
let _e2908 = select(_e918, _e2906, (_e2906 < _e918));
let _e2914 = global_4.member[bitcast<u32>(select(0i, _e2908, (_e2908 > 0i)))];
let _e2916 = -((_e2914 * _e2818));
let _e2918 = select(-87f, _e2916, (_e2916 > -87f));
let _e2920 = select(88f, _e2918, (_e2918 < 88f));
let _e2922 = ((_e2920 * 1.442695f) + 0.5f);
let _e2924 = select(-127f, _e2922, (_e2922 > -127f));
let _e2926 = select(128f, _e2924, (_e2924 < 128f));
let _e2933 = select(0i, select(select(i32(_e2926), i32(-2147483648), (_e2926 < -2147483600f)), 2147483647i, (_e2926 > 2147483500f)), (_e2926 == _e2926));
let _e2937 = (_e2933 - select(0i, 1i, (_e2926 < f32(_e2933))));
let _e2938 = f32(_e2937);
let _e2942 = ((_e2920 - (_e2938 * 0.6933594f)) - (_e2938 * -2.1219444e-4f));
let _e2963 = (_e2848 + 3i);
let _e2965 = select(_e918, _e2963, (_e2963 < _e918));
let _e2971 = global_4.member[bitcast<u32>(select(0i, _e2965, (_e2965 > 0i)))];
let _e2973 = -((_e2971 * _e2818));
let _e2975 = select(-87f, _e2973, (_e2973 > -87f));
let _e2977 = select(88f, _e2975, (_e2975 < 88f));
let _e2979 = ((_e2977 * 1.442695f) + 0.5f);
let _e2981 = select(-127f, _e2979, (_e2979 > -127f));
let _e2983 = select(128f, _e2981, (_e2981 < 128f));
let _e2990 = select(0i, select(select(i32(_e2983), i32(-2147483648), (_e2983 < -2147483600f)), 2147483647i, (_e2983 > 2147483500f)), (_e2983 == _e2983));
let _e2994 = (_e2990 - select(0i, 1i, (_e2983 < f32(_e2990))));
let _e2995 = f32(_e2994);
let _e2999 = ((_e2977 - (_e2995 * 0.6933594f)) - (_e2995 * -2.1219444e-4f));
phi_2809_ = type_20(_e2845.member, _e2845.member_1, vec3<f32>((_e832.member_2.x * ((1f + (_e2885 * (1f + (_e2885 * (0.5f + (_e2885 * (0.16666667f + (_e2885 * (0.041666668f + (_e2885 * (0.008333334f + (_e2885 * (0.001388889f + (_e2885 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2880 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.y * ((1f + (_e2942 * (1f + (_e2942 * (0.5f + (_e2942 * (0.16666667f + (_e2942 * (0.041666668f + (_e2942 * (0.008333334f + (_e2942 * (0.001388889f + (_e2942 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2937 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.z * ((1f + (_e2999 * (1f + (_e2999 * (0.5f + (_e2999 * (0.16666667f + (_e2999 * (0.041666668f + (_e2999 * (0.008333334f + (_e2999 * (0.001388889f + (_e2999 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2994 + 127i)) << bitcast<u32>(23i)))))), _e2845.member_3, _e2845.member_4, _e2845.member_5, _e2845.member_6, _e2845.member_7, _e2845.member_8, _e2845.member_9, _e2845.member_10, _e2845.member_11, _e2845.member_12, _e2845.member_13, _e2845.member_14, _e2845.member_15, _e2845.member_16, _e2845.member_17, _e2845.member_18, _e2845.member_19, _e2845.member_20, _e2845.member_21);
} else {
phi_2809_ = _e832;
}
let _e3053 = phi_2809_;
let _e3060 = type_21(0i, _e830.member_1, _e830.member_2, _e830.member_3, _e830.member_4);
let _e3065 = type_21(_e3060.member, 0i, _e3060.member_2, _e3060.member_3, _e3060.member_4);
let _e3077 = global_1.member.member_18.member.member;
let _e3091 = ((((_e3077.member.member * _e3053.member.x) + (_e3077.member.member_1 * _e3053.member.y)) + (_e3077.member.member_2 * _e3053.member.z)) + _e3077.member_1);
let _e3100 = -((((_e3077.member.member * _e3053.member_1.x) + (_e3077.member.member_1 * _e3053.member_1.y)) + (_e3077.member.member_2 * _e3053.member_1.z)));
let _e3102 = (_e3100 > 1e-9f);
let _e3106 = ((_e3091 / select(1e-9f, _e3100, _e3102)) - 0.015625f);
let _e3109 = select(1e30f, select(0f, _e3106, (_e3106 > 0f)), ((_e3091 > 0f) && _e3102));
let _e3114 = global_1.member.member_18.member_1.member;
let _e3125 = ((((_e3114.member.member * _e3053.member.x) + (_e3114.member.member_1 * _e3053.member.y)) + (_e3114.member.member_2 * _e3053.member.z)) + _e3114.member_1);
let _e3131 = -((((_e3114.member.member * _e3053.member_1.x) + (_e3114.member.member_1 * _e3053.member_1.y)) + (_e3114.member.member_2 * _e3053.member_1.z)));
let _e3133 = (_e3131 > 1e-9f);
let _e3137 = ((_e3125 / select(1e-9f, _e3131, _e3133)) - 0.015625f);
let _e3140 = select(1e30f, select(0f, _e3137, (_e3137 > 0f)), ((_e3125 > 0f) && _e3133));
let _e3144 = (_e3140 < _e3109);
let _e3169 = type_20(_e3053.member, _e3053.member_1, _e3053.member_2, _e3053.member_3, _e3053.member_4, _e3053.member_5, _e3053.member_6, _e3053.member_7, _e3053.member_8, _e3053.member_9, _e3053.member_10, _e3053.member_11, _e3053.member_12, _e3053.member_13, _e3053.member_14, _e3053.member_15, _e3053.member_16, _e3053.member_17, _e3053.member_18, 0i, _e3053.member_20, _e3053.member_21);
let _e3191 = type_20(_e3169.member, _e3169.member_1, _e3169.member_2, _e3169.member_3, _e3169.member_4, _e3169.member_5, _e3169.member_6, _e3169.member_7, _e3169.member_8, _e3169.member_9, _e3169.member_10, _e3169.member_11, _e3169.member_12, _e3169.member_13, _e3169.member_14, _e3169.member_15, _e3169.member_16, _e3169.member_17, _e3169.member_18, _e3169.member_19, select(select(-2i, -3i, _e3144), -1i, ((_e3109 >= 1e30f) && (_e3140 >= 1e30f))), _e3169.member_21);
phi_5499_ = type_21(_e3065.member, _e3065.member_1, select(1.1754944e-38f, _e830.member_3, (_e830.member_3 > 1.1754944e-38f)), _e3065.member_3, _e3065.member_4);
phi_5500_ = type_20(_e3191.member, _e3191.member_1, _e3191.member_2, _e3191.member_3, _e3191.member_4, _e3191.member_5, _e3191.member_6, _e3191.member_7, _e3191.member_8, _e3191.member_9, _e3191.member_10, _e3191.member_11, _e3191.member_12, _e3191.member_13, _e3191.member_14, _e3191.member_15, _e3191.member_16, _e3191.member_17, _e3191.member_18, _e3191.member_19, _e3191.member_20, select(_e3109, _e3140, _e3144));
phi_5501_ = _e871;
} else {
let _e936 = select(_e900, _e897, (_e897 < _e900));
let _e942 = global_3.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e943 = (_e897 + 1i);
let _e945 = select(_e900, _e943, (_e943 < _e900));
let _e951 = global_3.member[bitcast<u32>(select(0i, _e945, (_e945 > 0i)))];
let _e952 = (_e897 + 2i);
let _e954 = select(_e900, _e952, (_e952 < _e900));
let _e960 = global_3.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e961 = (_e897 + 3i);
let _e963 = select(_e900, _e961, (_e961 < _e900));
let _e969 = global_3.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e970 = (_e897 + 4i);
let _e972 = select(_e900, _e970, (_e970 < _e900));
let _e978 = global_3.member[bitcast<u32>(select(0i, _e972, (_e972 > 0i)))];
let _e979 = (_e897 + 5i);
let _e981 = select(_e900, _e979, (_e979 < _e900));
let _e987 = global_3.member[bitcast<u32>(select(0i, _e981, (_e981 > 0i)))];
let _e988 = (_e969 - _e942);
let _e989 = (_e978 - _e951);
let _e990 = (_e987 - _e960);
let _e991 = (_e897 + 6i);
let _e993 = select(_e900, _e991, (_e991 < _e900));
let _e999 = global_3.member[bitcast<u32>(select(0i, _e993, (_e993 > 0i)))];
let _e1000 = (_e897 + 7i);
let _e1002 = select(_e900, _e1000, (_e1000 < _e900));
let _e1008 = global_3.member[bitcast<u32>(select(0i, _e1002, (_e1002 > 0i)))];
let _e1009 = (_e897 + 8i);
let _e1011 = select(_e900, _e1009, (_e1009 < _e900));
let _e1017 = global_3.member[bitcast<u32>(select(0i, _e1011, (_e1011 > 0i)))];
let _e1018 = (_e999 - _e942);
let _e1019 = (_e1008 - _e951);
let _e1020 = (_e1017 - _e960);
let _e1023 = ((_e989 * _e1020) - (_e990 * _e1019));
let _e1026 = ((_e990 * _e1018) - (_e988 * _e1020));
let _e1029 = ((_e988 * _e1019) - (_e989 * _e1018));
let _e1034 = (((_e1023 * _e1023) + (_e1026 * _e1026)) + (_e1029 * _e1029));
let _e1037 = sqrt(select(0f, _e1034, (_e1034 > 0f)));
let _e1040 = (1f / select(1e-20f, _e1037, (_e1037 > 1e-20f)));
let _e1041 = (_e1023 * _e1040);
let _e1042 = (_e1026 * _e1040);
let _e1043 = (_e1029 * _e1040);
let _e1049 = bitcast<f32>((bitcast<u32>(_e832.member_1.x) & 2147483647u));
let _e1053 = bitcast<f32>((bitcast<u32>(_e832.member_1.y) & 2147483647u));
let _e1057 = bitcast<f32>((bitcast<u32>(_e832.member_1.z) & 2147483647u));
let _e1060 = ((_e1049 >= _e1053) && (_e1049 >= _e1057));
let _e1063 = (!(_e1060) && (_e1053 >= _e1057));
let _e1070 = (1f / select(select(_e832.member_1.z, _e832.member_1.y, _e1063), _e832.member_1.x, _e1060));
let _e1071 = (select(select(_e832.member_1.x, _e832.member_1.z, _e1063), _e832.member_1.y, _e1060) * _e1070);
let _e1072 = (select(select(_e832.member_1.y, _e832.member_1.x, _e1063), _e832.member_1.z, _e1060) * _e1070);
let _e1074 = (_e942 - _e832.member.x);
let _e1076 = (_e951 - _e832.member.y);
let _e1078 = (_e960 - _e832.member.z);
let _e1084 = select(select(_e1078, _e1076, _e1063), _e1074, _e1060);
let _e1086 = (select(select(_e1074, _e1078, _e1063), _e1076, _e1060) - (_e1071 * _e1084));
let _e1088 = (select(select(_e1076, _e1074, _e1063), _e1078, _e1060) - (_e1072 * _e1084));
let _e1089 = (_e969 - _e832.member.x);
let _e1090 = (_e978 - _e832.member.y);
let _e1091 = (_e987 - _e832.member.z);
let _e1097 = select(select(_e1091, _e1090, _e1063), _e1089, _e1060);
let _e1099 = (select(select(_e1089, _e1091, _e1063), _e1090, _e1060) - (_e1071 * _e1097));
let _e1101 = (select(select(_e1090, _e1089, _e1063), _e1091, _e1060) - (_e1072 * _e1097));
let _e1102 = (_e999 - _e832.member.x);
let _e1103 = (_e1008 - _e832.member.y);
let _e1104 = (_e1017 - _e832.member.z);
let _e1110 = select(select(_e1104, _e1103, _e1063), _e1102, _e1060);
let _e1112 = (select(select(_e1102, _e1104, _e1063), _e1103, _e1060) - (_e1071 * _e1110));
let _e1114 = (select(select(_e1103, _e1102, _e1063), _e1104, _e1060) - (_e1072 * _e1110));
let _e1117 = ((_e1112 * _e1101) - (_e1114 * _e1099));
let _e1120 = ((_e1086 * _e1114) - (_e1088 * _e1112));
let _e1123 = ((_e1099 * _e1088) - (_e1101 * _e1086));
let _e1125 = ((_e1117 + _e1120) + _e1123);
let _e1128 = (1f / select(_e1125, 1f, (_e1125 == 0f)));
let _e1129 = (_e1117 * _e1128);
let _e1130 = (_e1120 * _e1128);
let _e1131 = (_e1123 * _e1128);
let _e1132 = (_e897 + 9i);
let _e1134 = select(_e900, _e1132, (_e1132 < _e900));
let _e1140 = global_3.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1141 = (_e897 + 10i);
let _e1143 = select(_e900, _e1141, (_e1141 < _e900));
let _e1149 = global_3.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1150 = (_e897 + 11i);
let _e1152 = select(_e900, _e1150, (_e1150 < _e900));
let _e1158 = global_3.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1162 = (_e897 + 12i);
let _e1164 = select(_e900, _e1162, (_e1162 < _e900));
let _e1170 = global_3.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1171 = (_e897 + 13i);
let _e1173 = select(_e900, _e1171, (_e1171 < _e900));
let _e1179 = global_3.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1180 = (_e897 + 14i);
let _e1182 = select(_e900, _e1180, (_e1180 < _e900));
let _e1188 = global_3.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1195 = (_e897 + 15i);
let _e1197 = select(_e900, _e1195, (_e1195 < _e900));
let _e1203 = global_3.member[bitcast<u32>(select(0i, _e1197, (_e1197 > 0i)))];
let _e1204 = (_e897 + 16i);
let _e1206 = select(_e900, _e1204, (_e1204 < _e900));
let _e1212 = global_3.member[bitcast<u32>(select(0i, _e1206, (_e1206 > 0i)))];
let _e1213 = (_e897 + 17i);
let _e1215 = select(_e900, _e1213, (_e1213 < _e900));
let _e1221 = global_3.member[bitcast<u32>(select(0i, _e1215, (_e1215 > 0i)))];
let _e1225 = (((_e1140 * _e1129) + (_e1170 * _e1130)) + (_e1203 * _e1131));
let _e1226 = (((_e1149 * _e1129) + (_e1179 * _e1130)) + (_e1212 * _e1131));
let _e1227 = (((_e1158 * _e1129) + (_e1188 * _e1130)) + (_e1221 * _e1131));
let _e1232 = (((_e1225 * _e1225) + (_e1226 * _e1226)) + (_e1227 * _e1227));
let _e1235 = sqrt(select(0f, _e1232, (_e1232 > 0f)));
let _e1238 = (1f / select(1e-20f, _e1235, (_e1235 > 1e-20f)));
let _e1239 = (_e1225 * _e1238);
let _e1240 = (_e1226 * _e1238);
let _e1241 = (_e1227 * _e1238);
let _e1243 = local_3;
let _e1244 = (_e1243 * 4i);
let _e1246 = select(_e918, _e1244, (_e1244 < _e918));
let _e1252 = global_4.member[bitcast<u32>(select(0i, _e1246, (_e1246 > 0i)))];
let _e1253 = select(_e1252, 1f, _e893);
let _e1255 = local_4;
let _e1256 = (_e1255 * 4i);
let _e1258 = select(_e918, _e1256, (_e1256 < _e918));
let _e1264 = global_4.member[bitcast<u32>(select(0i, _e1258, (_e1258 > 0i)))];
let _e1266 = local_5;
let _e1268 = select(_e1264, 1f, (_e1266 == 16i));
let _e1275 = select(1f, -1f, ((((_e832.member_1.x * _e1239) + (_e832.member_1.y * _e1240)) + (_e832.member_1.z * _e1241)) > 0f));
let _e1276 = (_e1239 * _e1275);
let _e1277 = (_e1240 * _e1275);
let _e1278 = (_e1241 * _e1275);
let _e1284 = -((((_e832.member_1.x * _e1276) + (_e832.member_1.y * _e1277)) + (_e832.member_1.z * _e1278)));
let _e1286 = select(0f, _e1284, (_e1284 > 0f));
let _e1287 = (_e1253 / _e1268);
let _e1288 = (_e1287 * _e1287);
let _e1292 = (1f - (_e1288 * (1f - (_e1286 * _e1286))));
let _e1293 = (_e1292 <= 0f);
let _e1301 = ((_e1287 * _e1286) - sqrt(select(0f, _e1292, (_e1292 > 0f))));
let _e1308 = (2f * _e1286);
let _e1315 = select(((_e832.member_1.x * _e1287) + (_e1276 * _e1301)), (_e832.member_1.x + (_e1276 * _e1308)), _e1293);
let _e1316 = select(((_e832.member_1.y * _e1287) + (_e1277 * _e1301)), (_e832.member_1.y + (_e1277 * _e1308)), _e1293);
let _e1317 = select(((_e832.member_1.z * _e1287) + (_e1278 * _e1301)), (_e832.member_1.z + (_e1278 * _e1308)), _e1293);
let _e1322 = (((_e1315 * _e1315) + (_e1316 * _e1316)) + (_e1317 * _e1317));
let _e1325 = sqrt(select(0f, _e1322, (_e1322 > 0f)));
let _e1328 = (1f / select(1e-20f, _e1325, (_e1325 > 1e-20f)));
let _e1336 = (((_e832.member_1.x * _e1041) + (_e832.member_1.y * _e1042)) + (_e832.member_1.z * _e1043));
let _e1353 = ((((((_e1239 * _e832.member_1.x) + (_e1240 * _e832.member_1.y)) + (_e1241 * _e832.member_1.z)) * _e1336) > 0f) && (((((((_e1315 * _e1328) * _e1041) + ((_e1316 * _e1328) * _e1042)) + ((_e1317 * _e1328) * _e1043)) * select(1f, -1f, _e1293)) * _e1336) > 0f));
let _e1354 = select(_e1041, _e1239, _e1353);
let _e1355 = select(_e1042, _e1240, _e1353);
let _e1356 = select(_e1043, _e1241, _e1353);
let _e1360 = (_e832.member_21 - _e830.member_2);
let _e1362 = select(0f, _e1360, (_e1360 > 0f));
let _e1364 = local_6;
if (_e1364 != 16i) {
let _e1389 = type_20(_e832.member, _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, _e832.member_6, _e832.member_7, _e832.member_8, (_e832.member_9 + _e1362), _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e832.member_19, _e832.member_20, _e832.member_21);
let _e1390 = (_e1244 + 1i);
let _e1392 = select(_e918, _e1390, (_e1390 < _e918));
let _e1398 = global_4.member[bitcast<u32>(select(0i, _e1392, (_e1392 > 0i)))];
let _e1400 = -((_e1398 * _e1362));
let _e1402 = select(-87f, _e1400, (_e1400 > -87f));
let _e1404 = select(88f, _e1402, (_e1402 < 88f));
let _e1406 = ((_e1404 * 1.442695f) + 0.5f);
let _e1408 = select(-127f, _e1406, (_e1406 > -127f));
let _e1410 = select(128f, _e1408, (_e1408 < 128f));
let _e1417 = select(0i, select(select(i32(_e1410), i32(-2147483648), (_e1410 < -2147483600f)), 2147483647i, (_e1410 > 2147483500f)), (_e1410 == _e1410));
let _e1421 = (_e1417 - select(0i, 1i, (_e1410 < f32(_e1417))));
let _e1422 = f32(_e1421);
let _e1426 = ((_e1404 - (_e1422 * 0.6933594f)) - (_e1422 * -2.1219444e-4f));
let _e1447 = (_e1244 + 2i);
let _e1449 = select(_e918, _e1447, (_e1447 < _e918));
let _e1455 = global_4.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1457 = -((_e1455 * _e1362));
let _e1459 = select(-87f, _e1457, (_e1457 > -87f));
let _e1461 = select(88f, _e1459, (_e1459 < 88f));
let _e1463 = ((_e1461 * 1.442695f) + 0.5f);
let _e1465 = select(-127f, _e1463, (_e1463 > -127f));
let _e1467 = select(128f, _e1465, (_e1465 < 128f));
let _e1474 = select(0i, select(select(i32(_e1467), i32(-2147483648), (_e1467 < -2147483600f)), 2147483647i, (_e1467 > 2147483500f)), (_e1467 == _e1467));
let _e1478 = (_e1474 - select(0i, 1i, (_e1467 < f32(_e1474))));
let _e1479 = f32(_e1478);
let _e1483 = ((_e1461 - (_e1479 * 0.6933594f)) - (_e1479 * -2.1219444e-4f));
let _e1504 = (_e1244 + 3i);
let _e1506 = select(_e918, _e1504, (_e1504 < _e918));
let _e1512 = global_4.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1514 = -((_e1512 * _e1362));
let _e1516 = select(-87f, _e1514, (_e1514 > -87f));
let _e1518 = select(88f, _e1516, (_e1516 < 88f));
let _e1520 = ((_e1518 * 1.442695f) + 0.5f);
let _e1522 = select(-127f, _e1520, (_e1520 > -127f));
let _e1524 = select(128f, _e1522, (_e1522 < 128f));
let _e1531 = select(0i, select(select(i32(_e1524), i32(-2147483648), (_e1524 < -2147483600f)), 2147483647i, (_e1524 > 2147483500f)), (_e1524 == _e1524));
let _e1535 = (_e1531 - select(0i, 1i, (_e1524 < f32(_e1531))));
let _e1536 = f32(_e1535);
let _e1540 = ((_e1518 - (_e1536 * 0.6933594f)) - (_e1536 * -2.1219444e-4f));
phi_4091_ = type_20(_e1389.member, _e1389.member_1, vec3<f32>((_e832.member_2.x * ((1f + (_e1426 * (1f + (_e1426 * (0.5f + (_e1426 * (0.16666667f + (_e1426 * (0.041666668f + (_e1426 * (0.008333334f + (_e1426 * (0.001388889f + (_e1426 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1421 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.y * ((1f + (_e1483 * (1f + (_e1483 * (0.5f + (_e1483 * (0.16666667f + (_e1483 * (0.041666668f + (_e1483 * (0.008333334f + (_e1483 * (0.001388889f + (_e1483 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1478 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.z * ((1f + (_e1540 * (1f + (_e1540 * (0.5f + (_e1540 * (0.16666667f + (_e1540 * (0.041666668f + (_e1540 * (0.008333334f + (_e1540 * (0.001388889f + (_e1540 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1535 + 127i)) << bitcast<u32>(23i)))))), _e1389.member_3, _e1389.member_4, _e1389.member_5, _e1389.member_6, _e1389.member_7, _e1389.member_8, _e1389.member_9, _e1389.member_10, _e1389.member_11, _e1389.member_12, _e1389.member_13, _e1389.member_14, _e1389.member_15, _e1389.member_16, _e1389.member_17, _e1389.member_18, _e1389.member_19, _e1389.member_20, _e1389.member_21);
} else {
phi_4091_ = _e832;
}
let _e1594 = phi_4091_;
let _e1634 = type_20(vec3<f32>((_e1594.member.x + (_e1594.member_1.x * _e1594.member_21)), (_e1594.member.y + (_e1594.member_1.y * _e1594.member_21)), (_e1594.member.z + (_e1594.member_1.z * _e1594.member_21))), _e1594.member_1, _e1594.member_2, _e1594.member_3, _e1594.member_4, _e1594.member_5, _e1594.member_6, _e1594.member_7, _e1594.member_8, _e1594.member_9, _e1594.member_10, _e1594.member_11, _e1594.member_12, _e1594.member_13, _e1594.member_14, _e1594.member_15, _e1594.member_16, _e1594.member_17, _e1594.member_18, _e1594.member_19, _e1594.member_20, _e1594.member_21);
let _e1658 = type_20(_e1634.member, _e1634.member_1, _e1634.member_2, _e1634.member_3, _e1634.member_4, (_e1594.member_5 + _e1594.member_21), _e1634.member_6, _e1634.member_7, _e1634.member_8, _e1634.member_9, _e1634.member_10, _e1634.member_11, _e1634.member_12, _e1634.member_13, _e1634.member_14, _e1634.member_15, _e1634.member_16, _e1634.member_17, _e1634.member_18, _e1634.member_19, _e1634.member_20, _e1634.member_21);
let _e1660 = (_e1594.member_8 == 0f);
let _e1685 = type_20(_e1658.member, _e1658.member_1, _e1658.member_2, _e1658.member_3, _e1658.member_4, _e1658.member_5, _e1658.member_6, _e1658.member_7, _e1658.member_8, _e1658.member_9, (_e1594.member_10 + select(0f, _e1594.member_21, _e1660)), _e1658.member_11, _e1658.member_12, _e1658.member_13, _e1658.member_14, _e1658.member_15, _e1658.member_16, _e1658.member_17, _e1658.member_18, _e1658.member_19, _e1658.member_20, _e1658.member_21);
let _e1690 = type_21(0i, _e830.member_1, _e830.member_2, _e830.member_3, _e830.member_4);
let _e1695 = type_21(_e1690.member, 0i, _e1690.member_2, _e1690.member_3, _e1690.member_4);
if (_e836 == 0i) {
phi_4386_ = 16i;
} else {
phi_4386_ = -(_e836);
}
let _e1704 = phi_4386_;
let _e1726 = type_20(_e1685.member, _e1685.member_1, _e1685.member_2, _e1685.member_3, _e1685.member_4, _e1685.member_5, _e1685.member_6, _e1704, _e1685.member_8, _e1685.member_9, _e1685.member_10, _e1685.member_11, _e1685.member_12, _e1685.member_13, _e1685.member_14, _e1685.member_15, _e1685.member_16, _e1685.member_17, _e1685.member_18, _e1685.member_19, _e1685.member_20, _e1685.member_21);
let _e1733 = select(1f, -1f, ((((_e1594.member_1.x * _e1354) + (_e1594.member_1.y * _e1355)) + (_e1594.member_1.z * _e1356)) > 0f));
let _e1734 = (_e1354 * _e1733);
let _e1735 = (_e1355 * _e1733);
let _e1736 = (_e1356 * _e1733);
let _e1742 = -((((_e1594.member_1.x * _e1734) + (_e1594.member_1.y * _e1735)) + (_e1594.member_1.z * _e1736)));
let _e1744 = select(0f, _e1742, (_e1742 > 0f));
let _e1745 = (_e1744 * _e1744);
let _e1748 = (1f - (_e1288 * (1f - _e1745)));
let _e1749 = (_e1748 <= 0f);
let _e1757 = ((_e1287 * _e1744) - sqrt(select(0f, _e1748, (_e1748 > 0f))));
let _e1764 = (2f * _e1744);
let _e1765 = (_e1734 * _e1764);
let _e1766 = (_e1735 * _e1764);
let _e1767 = (_e1736 * _e1764);
let _e1773 = select(((_e1594.member_1.x * _e1287) + (_e1734 * _e1757)), (_e1594.member_1.x + _e1765), _e1749);
let _e1774 = select(((_e1594.member_1.y * _e1287) + (_e1735 * _e1757)), (_e1594.member_1.y + _e1766), _e1749);
let _e1775 = select(((_e1594.member_1.z * _e1287) + (_e1736 * _e1757)), (_e1594.member_1.z + _e1767), _e1749);
let _e1780 = (((_e1773 * _e1773) + (_e1774 * _e1774)) + (_e1775 * _e1775));
let _e1783 = sqrt(select(0f, _e1780, (_e1780 > 0f)));
let _e1786 = (1f / select(1e-20f, _e1783, (_e1783 > 1e-20f)));
let _e1791 = (_e1268 / _e1253);
let _e1794 = (((_e1791 * _e1791) - 1f) + _e1745);
let _e1797 = sqrt(select(0f, _e1794, (_e1794 > 0f)));
let _e1798 = (_e1797 - _e1744);
let _e1799 = (_e1797 + _e1744);
let _e1802 = (_e1798 / select(1e-6f, _e1799, (_e1799 > 1e-6f)));
let _e1806 = ((_e1744 * _e1798) + 1f);
let _e1809 = (((_e1744 * _e1799) - 1f) / select(1e-6f, _e1806, (_e1806 > 1e-6f)));
let _e1821 = global_1.member.member_1;
let _e1824 = select(0f, select(select((((0.5f * _e1802) * _e1802) * (1f + (_e1809 * _e1809))), 1f, (_e1794 <= 0f)), 0f, (_e1253 == _e1268)), ((_e1821 & 1u) != 0u));
let _e1825 = (_e1660 && _e893);
if _e1660 {
let _e1847 = type_20(_e1726.member, _e1726.member_1, _e1726.member_2, vec3<f32>(_e1354, _e1355, _e1356), _e1726.member_4, _e1726.member_5, _e1726.member_6, _e1726.member_7, _e1726.member_8, _e1726.member_9, _e1726.member_10, _e1726.member_11, _e1726.member_12, _e1726.member_13, _e1726.member_14, _e1726.member_15, _e1726.member_16, _e1726.member_17, _e1726.member_18, _e1726.member_19, _e1726.member_20, _e1726.member_21);
phi_4606_ = type_20(_e1847.member, _e1847.member_1, _e1847.member_2, _e1847.member_3, _e1847.member_4, _e1847.member_5, _e1847.member_6, _e1847.member_7, _e1847.member_8, _e1847.member_9, _e1847.member_10, select(0f, _e1824, _e1825), _e1847.member_12, _e1847.member_13, _e1847.member_14, _e1847.member_15, _e1847.member_16, _e1847.member_17, _e1847.member_18, _e1847.member_19, _e1847.member_20, _e1847.member_21);
} else {
phi_4606_ = _e1726;
}
let _e1872 = phi_4606_;
let _e1874 = !(_e1749);
if (!(_e1825) && _e1874) {
let _e1880 = select(_e1872.member_5, _e1872.member_9, (_e1872.member_8 == 0f));
let _e1881 = (_e1244 + 1i);
let _e1883 = select(_e918, _e1881, (_e1881 < _e918));
let _e1889 = global_4.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1891 = -((_e1889 * _e1880));
let _e1893 = select(-87f, _e1891, (_e1891 > -87f));
let _e1895 = select(88f, _e1893, (_e1893 < 88f));
let _e1897 = ((_e1895 * 1.442695f) + 0.5f);
let _e1899 = select(-127f, _e1897, (_e1897 > -127f));
let _e1901 = select(128f, _e1899, (_e1899 < 128f));
let _e1908 = select(0i, select(select(i32(_e1901), i32(-2147483648), (_e1901 < -2147483600f)), 2147483647i, (_e1901 > 2147483500f)), (_e1901 == _e1901));
let _e1912 = (_e1908 - select(0i, 1i, (_e1901 < f32(_e1908))));
let _e1913 = f32(_e1912);
let _e1917 = ((_e1895 - (_e1913 * 0.6933594f)) - (_e1913 * -2.1219444e-4f));
let _e1938 = (_e1244 + 2i);
let _e1940 = select(_e918, _e1938, (_e1938 < _e918));
let _e1946 = global_4.member[bitcast<u32>(select(0i, _e1940, (_e1940 > 0i)))];
let _e1948 = -((_e1946 * _e1880));
let _e1950 = select(-87f, _e1948, (_e1948 > -87f));
let _e1952 = select(88f, _e1950, (_e1950 < 88f));
let _e1954 = ((_e1952 * 1.442695f) + 0.5f);
let _e1956 = select(-127f, _e1954, (_e1954 > -127f));
let _e1958 = select(128f, _e1956, (_e1956 < 128f));
let _e1965 = select(0i, select(select(i32(_e1958), i32(-2147483648), (_e1958 < -2147483600f)), 2147483647i, (_e1958 > 2147483500f)), (_e1958 == _e1958));
let _e1969 = (_e1965 - select(0i, 1i, (_e1958 < f32(_e1965))));
let _e1970 = f32(_e1969);
let _e1974 = ((_e1952 - (_e1970 * 0.6933594f)) - (_e1970 * -2.1219444e-4f));
let _e1995 = (_e1244 + 3i);
let _e1997 = select(_e918, _e1995, (_e1995 < _e918));
let _e2003 = global_4.member[bitcast<u32>(select(0i, _e1997, (_e1997 > 0i)))];
let _e2005 = -((_e2003 * _e1880));
let _e2007 = select(-87f, _e2005, (_e2005 > -87f));
let _e2009 = select(88f, _e2007, (_e2007 < 88f));
let _e2011 = ((_e2009 * 1.442695f) + 0.5f);
let _e2013 = select(-127f, _e2011, (_e2011 > -127f));
let _e2015 = select(128f, _e2013, (_e2013 < 128f));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2027 = f32(_e2026);
let _e2031 = ((_e2009 - (_e2027 * 0.6933594f)) - (_e2027 * -2.1219444e-4f));
let _e2053 = select(((1f + (_e1917 * (1f + (_e1917 * (0.5f + (_e1917 * (0.16666667f + (_e1917 * (0.041666668f + (_e1917 * (0.008333334f + (_e1917 * (0.001388889f + (_e1917 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1912 + 127i)) << bitcast<u32>(23i)))), 1f, _e893);
let _e2055 = (1f - (_e1824 * _e2053));
let _e2057 = (1f - _e1824);
let _e2063 = select(((1f + (_e1974 * (1f + (_e1974 * (0.5f + (_e1974 * (0.16666667f + (_e1974 * (0.041666668f + (_e1974 * (0.008333334f + (_e1974 * (0.001388889f + (_e1974 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1969 + 127i)) << bitcast<u32>(23i)))), 1f, _e893);
let _e2065 = (1f - (_e1824 * _e2063));
let _e2072 = select(((1f + (_e2031 * (1f + (_e2031 * (0.5f + (_e2031 * (0.16666667f + (_e2031 * (0.041666668f + (_e2031 * (0.008333334f + (_e2031 * (0.001388889f + (_e2031 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2026 + 127i)) << bitcast<u32>(23i)))), 1f, _e893);
let _e2074 = (1f - (_e1824 * _e2072));
let _e2087 = ((_e1872.member_2.x * select(1f, ((_e2057 * _e2053) / select(1e-9f, _e2055, (_e2055 > 1e-9f))), (_e2055 > 0f))) * _e1824);
let _e2088 = ((_e1872.member_2.y * select(1f, ((_e2057 * _e2063) / select(1e-9f, _e2065, (_e2065 > 1e-9f))), (_e2065 > 0f))) * _e1824);
let _e2089 = ((_e1872.member_2.z * select(1f, ((_e2057 * _e2072) / select(1e-9f, _e2074, (_e2074 > 1e-9f))), (_e2074 > 0f))) * _e1824);
if (((_e1821 & 8u) != 0u) && (((_e2087 + _e2088) + _e2089) > ((_e1872.member_17.x + _e1872.member_17.y) + _e1872.member_17.z))) {
let _e2166 = type_20(_e1872.member, _e1872.member_1, _e1872.member_2, _e1872.member_3, _e1872.member_4, _e1872.member_5, _e1872.member_6, _e1872.member_7, _e1872.member_8, _e1872.member_9, _e1872.member_10, _e1872.member_11, vec3<f32>((_e1872.member_12.x + _e1872.member_17.x), (_e1872.member_12.y + _e1872.member_17.y), (_e1872.member_12.z + _e1872.member_17.z)), _e1872.member_13, _e1872.member_14, _e1872.member_15, _e1872.member_16, _e1872.member_17, _e1872.member_18, _e1872.member_19, _e1872.member_20, _e1872.member_21);
let _e2189 = type_20(_e2166.member, _e2166.member_1, _e2166.member_2, _e2166.member_3, _e2166.member_4, _e2166.member_5, _e2166.member_6, _e2166.member_7, _e2166.member_8, _e2166.member_9, _e2166.member_10, _e2166.member_11, _e2166.member_12, _e1872.member, _e2166.member_14, _e2166.member_15, _e2166.member_16, _e2166.member_17, _e2166.member_18, _e2166.member_19, _e2166.member_20, _e2166.member_21);
let _e2211 = type_20(_e2189.member, _e2189.member_1, _e2189.member_2, _e2189.member_3, _e2189.member_4, _e2189.member_5, _e2189.member_6, _e2189.member_7, _e2189.member_8, _e2189.member_9, _e2189.member_10, _e2189.member_11, _e2189.member_12, _e2189.member_13, (_e1594.member_1 + vec3<f32>(_e1765, _e1766, _e1767)), _e2189.member_15, _e2189.member_16, _e2189.member_17, _e2189.member_18, _e2189.member_19, _e2189.member_20, _e2189.member_21);
let _e2234 = type_20(_e2211.member, _e2211.member_1, _e2211.member_2, _e2211.member_3, _e2211.member_4, _e2211.member_5, _e2211.member_6, _e2211.member_7, _e2211.member_8, _e2211.member_9, _e2211.member_10, _e2211.member_11, _e2211.member_12, _e2211.member_13, _e2211.member_14, _e2211.member_15, (_e1872.member_2 * _e1824), _e2211.member_17, _e2211.member_18, _e2211.member_19, _e2211.member_20, _e2211.member_21);
let _e2256 = type_20(_e2234.member, _e2234.member_1, _e2234.member_2, _e2234.member_3, _e2234.member_4, _e2234.member_5, _e2234.member_6, _e2234.member_7, _e2234.member_8, _e2234.member_9, _e2234.member_10, _e2234.member_11, _e2234.member_12, _e2234.member_13, _e2234.member_14, _e2234.member_15, _e2234.member_16, vec3<f32>(_e2087, _e2088, _e2089), _e2234.member_18, _e2234.member_19, _e2234.member_20, _e2234.member_21);
phi_4978_ = type_20(_e2256.member, _e2256.member_1, _e2256.member_2, _e2256.member_3, _e2256.member_4, _e2256.member_5, _e2256.member_6, _e2256.member_7, _e2256.member_8, _e2256.member_9, _e2256.member_10, _e2256.member_11, _e2256.member_12, _e2256.member_13, _e2256.member_14, _e2256.member_15, _e2256.member_16, _e2256.member_17, _e1872.member_7, _e2256.member_19, _e2256.member_20, _e2256.member_21);
} else {
phi_4978_ = type_20(_e1872.member, _e1872.member_1, _e1872.member_2, _e1872.member_3, _e1872.member_4, _e1872.member_5, _e1872.member_6, _e1872.member_7, _e1872.member_8, _e1872.member_9, _e1872.member_10, _e1872.member_11, vec3<f32>((_e1872.member_12.x + _e2087), (_e1872.member_12.y + _e2088), (_e1872.member_12.z + _e2089)), _e1872.member_13, _e1872.member_14, _e1872.member_15, _e1872.member_16, _e1872.member_17, _e1872.member_18, _e1872.member_19, _e1872.member_20, _e1872.member_21);
}
let _e2281 = phi_4978_;
phi_4979_ = _e2281;
} else {
phi_4979_ = _e1872;
}
let _e2283 = phi_4979_;
let _e2285 = (_e2283.member_8 + 1f);
let _e2307 = type_20(_e2283.member, _e2283.member_1, _e2283.member_2, _e2283.member_3, _e2283.member_4, _e2283.member_5, _e2283.member_6, _e2283.member_7, _e2285, _e2283.member_9, _e2283.member_10, _e2283.member_11, _e2283.member_12, _e2283.member_13, _e2283.member_14, _e2283.member_15, _e2283.member_16, _e2283.member_17, _e2283.member_18, _e2283.member_19, _e2283.member_20, _e2283.member_21);
let _e2310 = ((_e129.member_2 == 0u) && (_e2285 >= 2f));
if (_e1749 && _e2310) {
let _e2342 = (((_e2283.member_1.x * _e1354) + (_e2283.member_1.y * _e1355)) + (_e2283.member_1.z * _e1356));
let _e2346 = (_e2283.member_1.x - (_e1354 * _e2342));
let _e2347 = (_e2283.member_1.y - (_e1355 * _e2342));
let _e2348 = (_e2283.member_1.z - (_e1356 * _e2342));
let _e2353 = (((_e2346 * _e2346) + (_e2347 * _e2347)) + (_e2348 * _e2348));
let _e2356 = sqrt(select(0f, _e2353, (_e2353 > 0f)));
let _e2359 = (1f / select(1e-20f, _e2356, (_e2356 > 1e-20f)));
phi_5032_ = type_20(_e2307.member, vec3<f32>((_e2346 * _e2359), (_e2347 * _e2359), (_e2348 * _e2359)), _e2307.member_2, _e2307.member_3, _e2307.member_4, _e2307.member_5, _e2307.member_6, _e2307.member_7, _e2307.member_8, _e2307.member_9, _e2307.member_10, _e2307.member_11, _e2307.member_12, _e2307.member_13, _e2307.member_14, _e2307.member_15, _e2307.member_16, _e2307.member_17, _e2307.member_18, _e2307.member_19, _e2307.member_20, _e2307.member_21);
} else {
phi_5032_ = type_20(_e2307.member, vec3<f32>((_e1773 * _e1786), (_e1774 * _e1786), (_e1775 * _e1786)), _e2307.member_2, _e2307.member_3, _e2307.member_4, _e2307.member_5, _e2307.member_6, _e2307.member_7, _e2307.member_8, _e2307.member_9, _e2307.member_10, _e2307.member_11, _e2307.member_12, _e2307.member_13, _e2307.member_14, _e2307.member_15, _e2307.member_16, _e2307.member_17, _e2307.member_18, _e2307.member_19, _e2307.member_20, _e2307.member_21);
}
let _e2387 = phi_5032_;
if _e1749 {
phi_5046_ = _e2387;
} else {
let _e2388 = (1f - _e1824);
phi_5046_ = type_20(_e2387.member, _e2387.member_1, vec3<f32>((_e2387.member_2.x * _e2388), (_e2387.member_2.y * _e2388), (_e2387.member_2.z * _e2388)), _e2387.member_3, _e2387.member_4, _e2387.member_5, _e2387.member_6, _e2387.member_7, _e2387.member_8, _e2387.member_9, _e2387.member_10, _e2387.member_11, _e2387.member_12, _e2387.member_13, _e2387.member_14, _e2387.member_15, _e2387.member_16, _e2387.member_17, _e2387.member_18, _e2387.member_19, _e2387.member_20, _e2387.member_21);
}
let _e2422 = phi_5046_;
let _e2444 = type_20(_e2422.member, _e2422.member_1, _e2422.member_2, _e2422.member_3, _e2422.member_4, 0f, _e2422.member_6, _e2422.member_7, _e2422.member_8, _e2422.member_9, _e2422.member_10, _e2422.member_11, _e2422.member_12, _e2422.member_13, _e2422.member_14, _e2422.member_15, _e2422.member_16, _e2422.member_17, _e2422.member_18, _e2422.member_19, _e2422.member_20, _e2422.member_21);
let _e2451 = global_1.member.member_18.member.member;
let _e2465 = ((((_e2451.member.member * _e2422.member.x) + (_e2451.member.member_1 * _e2422.member.y)) + (_e2451.member.member_2 * _e2422.member.z)) + _e2451.member_1);
let _e2474 = -((((_e2451.member.member * _e2422.member_1.x) + (_e2451.member.member_1 * _e2422.member_1.y)) + (_e2451.member.member_2 * _e2422.member_1.z)));
let _e2476 = (_e2474 > 1e-9f);
let _e2480 = ((_e2465 / select(1e-9f, _e2474, _e2476)) - 0.015625f);
let _e2483 = select(1e30f, select(0f, _e2480, (_e2480 > 0f)), ((_e2465 > 0f) && _e2476));
let _e2488 = global_1.member.member_18.member_1.member;
let _e2499 = ((((_e2488.member.member * _e2422.member.x) + (_e2488.member.member_1 * _e2422.member.y)) + (_e2488.member.member_2 * _e2422.member.z)) + _e2488.member_1);
let _e2505 = -((((_e2488.member.member * _e2422.member_1.x) + (_e2488.member.member_1 * _e2422.member_1.y)) + (_e2488.member.member_2 * _e2422.member_1.z)));
let _e2507 = (_e2505 > 1e-9f);
let _e2511 = ((_e2499 / select(1e-9f, _e2505, _e2507)) - 0.015625f);
let _e2514 = select(1e30f, select(0f, _e2511, (_e2511 > 0f)), ((_e2499 > 0f) && _e2507));
let _e2518 = (_e2514 < _e2483);
let _e2520 = select(select(-2i, -3i, _e2518), -1i, ((_e2483 >= 1e30f) && (_e2514 >= 1e30f)));
let _e2521 = select(_e2483, _e2514, _e2518);
let _e2543 = type_20(_e2444.member, _e2444.member_1, _e2444.member_2, _e2444.member_3, _e2444.member_4, _e2444.member_5, _e2444.member_6, _e2444.member_7, _e2444.member_8, _e2444.member_9, _e2444.member_10, _e2444.member_11, _e2444.member_12, _e2444.member_13, _e2444.member_14, _e2444.member_15, _e2444.member_16, _e2444.member_17, _e2444.member_18, 0i, _e2444.member_20, _e2444.member_21);
let _e2565 = type_20(_e2543.member, _e2543.member_1, _e2543.member_2, _e2543.member_3, _e2543.member_4, _e2543.member_5, _e2543.member_6, _e2543.member_7, _e2543.member_8, _e2543.member_9, _e2543.member_10, _e2543.member_11, _e2543.member_12, _e2543.member_13, _e2543.member_14, _e2543.member_15, _e2543.member_16, _e2543.member_17, _e2543.member_18, _e2543.member_19, _e2520, _e2543.member_21);
let _e2587 = type_20(_e2565.member, _e2565.member_1, _e2565.member_2, _e2565.member_3, _e2565.member_4, _e2565.member_5, _e2565.member_6, _e2565.member_7, _e2565.member_8, _e2565.member_9, _e2565.member_10, _e2565.member_11, _e2565.member_12, _e2565.member_13, _e2565.member_14, _e2565.member_15, _e2565.member_16, _e2565.member_17, _e2565.member_18, _e2565.member_19, _e2565.member_20, _e2521);
let _e2589 = local_7;
let _e2591 = local_8;
let _e2594 = ((_e1821 & 2u) != 0u);
if (_e2310 && !(_e2594)) {
if (_e2520 == -1i) {
phi_5472_ = type_20(_e2587.member, _e2587.member_1, _e2587.member_2, _e2587.member_3, _e2587.member_4, _e2587.member_5, 1f, _e2587.member_7, _e2587.member_8, _e2587.member_9, _e2587.member_10, _e2587.member_11, _e2587.member_12, _e2587.member_13, _e2587.member_14, _e2587.member_15, _e2587.member_16, _e2587.member_17, _e2587.member_18, _e2587.member_19, _e2587.member_20, _e2587.member_21);
} else {
let _e2691 = type_20(vec3<f32>((_e2422.member.x + (_e2422.member_1.x * _e2521)), (_e2422.member.y + (_e2422.member_1.y * _e2521)), (_e2422.member.z + (_e2422.member_1.z * _e2521))), _e2587.member_1, _e2587.member_2, _e2587.member_3, _e2587.member_4, _e2587.member_5, _e2587.member_6, _e2587.member_7, _e2587.member_8, _e2587.member_9, _e2587.member_10, _e2587.member_11, _e2587.member_12, _e2587.member_13, _e2587.member_14, _e2587.member_15, _e2587.member_16, _e2587.member_17, _e2587.member_18, _e2587.member_19, _e2587.member_20, _e2587.member_21);
let _e2714 = type_20(_e2691.member, _e2691.member_1, _e2691.member_2, _e2691.member_3, _e2691.member_4, (0f + _e2521), _e2691.member_6, _e2691.member_7, _e2691.member_8, _e2691.member_9, _e2691.member_10, _e2691.member_11, _e2691.member_12, _e2691.member_13, _e2691.member_14, _e2691.member_15, _e2691.member_16, _e2691.member_17, _e2691.member_18, _e2691.member_19, _e2691.member_20, _e2691.member_21);
let _e2737 = type_20(_e2714.member, _e2714.member_1, _e2714.member_2, _e2714.member_3, _e2714.member_4, _e2714.member_5, _e2714.member_6, _e2714.member_7, _e2714.member_8, _e2714.member_9, _e2714.member_10, _e2714.member_11, _e2714.member_12, _e2714.member_13, _e2714.member_14, _e2714.member_15, _e2714.member_16, _e2714.member_17, _e2714.member_18, _e2714.member_19, _e2714.member_20, (_e2521 - _e2521));
let _e2764 = type_20(_e2737.member, _e2737.member_1, _e2737.member_2, _e2737.member_3, _e2737.member_4, _e2737.member_5, _e2737.member_6, _e2737.member_7, _e2737.member_8, _e2737.member_9, (_e2422.member_10 + select(0f, _e2521, (_e2422.member_8 == 0f))), _e2737.member_11, _e2737.member_12, _e2737.member_13, _e2737.member_14, _e2737.member_15, _e2737.member_16, _e2737.member_17, _e2737.member_18, _e2737.member_19, _e2737.member_20, _e2737.member_21);
phi_5472_ = type_20(_e2764.member, _e2764.member_1, _e2764.member_2, _e2764.member_3, _e2764.member_4, _e2764.member_5, 3f, _e2764.member_7, _e2764.member_8, _e2764.member_9, _e2764.member_10, _e2764.member_11, _e2764.member_12, _e2764.member_13, _e2764.member_14, _e2764.member_15, _e2764.member_16, _e2764.member_17, _e2764.member_18, _e2764.member_19, _e2764.member_20, _e2764.member_21);
}
let _e2810 = phi_5472_;
phi_5493_ = _e2810;
} else {
let _e2601 = global_1.member.member_5;
if ((!(_e2310) && (_e2422.member_8 >= f32(bitcast<i32>(_e2601)))) && (select(_e2591, _e2589, _e1749) != 16i)) {
phi_5492_ = type_20(_e2587.member, _e2587.member_1, _e2587.member_2, _e2587.member_3, _e2587.member_4, _e2587.member_5, 2f, _e2587.member_7, _e2587.member_8, _e2587.member_9, _e2587.member_10, _e2587.member_11, _e2587.member_12, _e2587.member_13, _e2587.member_14, _e2587.member_15, _e2587.member_16, _e2587.member_17, _e2587.member_18, _e2587.member_19, _e2587.member_20, _e2587.member_21);
} else {
if _e2594 {
phi_5491_ = type_20(_e2587.member, _e2587.member_1, _e2587.member_2, _e2587.member_3, _e2587.member_4, _e2587.member_5, 4f, _e2587.member_7, _e2587.member_8, _e2587.member_9, _e2587.member_10, _e2587.member_11, _e2587.member_12, _e2587.member_13, _e2587.member_14, _e2587.member_15, _e2587.member_16, _e2587.member_17, _e2587.member_18, _e2587.member_19, _e2587.member_20, _e2587.member_21);
} else {
phi_5491_ = _e2587;
}
let _e2631 = phi_5491_;
phi_5492_ = _e2631;
}
let _e2655 = phi_5492_;
phi_5493_ = _e2655;
}
let _e2812 = phi_5493_;
phi_5499_ = type_21(_e1695.member, _e1695.member_1, 0f, _e1695.member_3, _e1695.member_4);
phi_5500_ = _e2812;
phi_5501_ = select(_e836, _e871, _e1874);
}
let _e3215 = phi_5499_;
let _e3217 = phi_5500_;
let _e3219 = phi_5501_;
phi_5502_ = _e3215;
phi_5503_ = _e3217;
phi_5504_ = _e3219;
}
let _e3221 = phi_5502_;
let _e3223 = phi_5503_;
let _e3225 = phi_5504_;
phi_5506_ = _e3221;
phi_5507_ = _e3223;
phi_5508_ = _e3225;
phi_5510_ = select(true, false, _e929);
}
let _e3228 = phi_5506_;
let _e3230 = phi_5507_;
let _e3232 = phi_5508_;
let _e3234 = phi_5510_;
phi_5521_ = _e3228;
phi_5522_ = _e3230;
phi_5523_ = _e3232;
phi_5525_ = select(_e929, false, _e895);
phi_5526_ = _e3234;
} else {
phi_5521_ = type_21();
phi_5522_ = type_20();
phi_5523_ = i32();
phi_5525_ = select(true, false, _e895);
phi_5526_ = false;
}
let _e3237 = phi_5521_;
let _e3239 = phi_5522_;
let _e3241 = phi_5523_;
let _e3243 = phi_5525_;
let _e3245 = phi_5526_;
if _e895 {
if _e890 {
phi_5823_ = type_20(_e832.member, _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, 1f, _e832.member_7, _e832.member_8, _e832.member_9, _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e832.member_19, _e832.member_20, _e832.member_21);
} else {
let _e3285 = type_20(vec3<f32>((_e832.member.x + (_e832.member_1.x * _e832.member_21)), (_e832.member.y + (_e832.member_1.y * _e832.member_21)), (_e832.member.z + (_e832.member_1.z * _e832.member_21))), _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, _e832.member_6, _e832.member_7, _e832.member_8, _e832.member_9, _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e832.member_19, _e832.member_20, _e832.member_21);
let _e3309 = type_20(_e3285.member, _e3285.member_1, _e3285.member_2, _e3285.member_3, _e3285.member_4, (_e832.member_5 + _e832.member_21), _e3285.member_6, _e3285.member_7, _e3285.member_8, _e3285.member_9, _e3285.member_10, _e3285.member_11, _e3285.member_12, _e3285.member_13, _e3285.member_14, _e3285.member_15, _e3285.member_16, _e3285.member_17, _e3285.member_18, _e3285.member_19, _e3285.member_20, _e3285.member_21);
let _e3332 = type_20(_e3309.member, _e3309.member_1, _e3309.member_2, _e3309.member_3, _e3309.member_4, _e3309.member_5, _e3309.member_6, _e3309.member_7, _e3309.member_8, _e3309.member_9, _e3309.member_10, _e3309.member_11, _e3309.member_12, _e3309.member_13, _e3309.member_14, _e3309.member_15, _e3309.member_16, _e3309.member_17, _e3309.member_18, _e3309.member_19, _e3309.member_20, (_e832.member_21 - _e832.member_21));
let _e3359 = type_20(_e3332.member, _e3332.member_1, _e3332.member_2, _e3332.member_3, _e3332.member_4, _e3332.member_5, _e3332.member_6, _e3332.member_7, _e3332.member_8, _e3332.member_9, (_e832.member_10 + select(0f, _e832.member_21, (_e832.member_8 == 0f))), _e3332.member_11, _e3332.member_12, _e3332.member_13, _e3332.member_14, _e3332.member_15, _e3332.member_16, _e3332.member_17, _e3332.member_18, _e3332.member_19, _e3332.member_20, _e3332.member_21);
phi_5823_ = type_20(_e3359.member, _e3359.member_1, _e3359.member_2, _e3359.member_3, _e3359.member_4, _e3359.member_5, 3f, _e3359.member_7, _e3359.member_8, _e3359.member_9, _e3359.member_10, _e3359.member_11, _e3359.member_12, _e3359.member_13, _e3359.member_14, _e3359.member_15, _e3359.member_16, _e3359.member_17, _e3359.member_18, _e3359.member_19, _e3359.member_20, _e3359.member_21);
}
let _e3405 = phi_5823_;
phi_5824_ = _e3405;
} else {
phi_5824_ = type_20();
}
let _e3407 = phi_5824_;
let _e3408 = select(_e3243, false, _e895);
if _e3408 {
let _e3412 = (_e832.member_21 - _e830.member_2);
let _e3414 = select(0f, _e3412, (_e3412 > 0f));
let _e3416 = local_11;
if (_e3416 != 16i) {
let _e3441 = type_20(_e832.member, _e832.member_1, _e832.member_2, _e832.member_3, _e832.member_4, _e832.member_5, _e832.member_6, _e832.member_7, _e832.member_8, (_e832.member_9 + _e3414), _e832.member_10, _e832.member_11, _e832.member_12, _e832.member_13, _e832.member_14, _e832.member_15, _e832.member_16, _e832.member_17, _e832.member_18, _e832.member_19, _e832.member_20, _e832.member_21);
let _e3443 = local_12;
let _e3444 = (_e3443 * 4i);
let _e3445 = (_e3444 + 1i);
let _e3447 = (bitcast<i32>(_e122) - 1i);
let _e3449 = select(_e3447, _e3445, (_e3445 < _e3447));
let _e3455 = global_4.member[bitcast<u32>(select(0i, _e3449, (_e3449 > 0i)))];
let _e3457 = -((_e3455 * _e3414));
let _e3459 = select(-87f, _e3457, (_e3457 > -87f));
let _e3461 = select(88f, _e3459, (_e3459 < 88f));
let _e3463 = ((_e3461 * 1.442695f) + 0.5f);
let _e3465 = select(-127f, _e3463, (_e3463 > -127f));
let _e3467 = select(128f, _e3465, (_e3465 < 128f));
let _e3474 = select(0i, select(select(i32(_e3467), i32(-2147483648), (_e3467 < -2147483600f)), 2147483647i, (_e3467 > 2147483500f)), (_e3467 == _e3467));
let _e3478 = (_e3474 - select(0i, 1i, (_e3467 < f32(_e3474))));
let _e3479 = f32(_e3478);
let _e3483 = ((_e3461 - (_e3479 * 0.6933594f)) - (_e3479 * -2.1219444e-4f));
let _e3504 = (_e3444 + 2i);
let _e3506 = select(_e3447, _e3504, (_e3504 < _e3447));
let _e3512 = global_4.member[bitcast<u32>(select(0i, _e3506, (_e3506 > 0i)))];
let _e3514 = -((_e3512 * _e3414));
let _e3516 = select(-87f, _e3514, (_e3514 > -87f));
let _e3518 = select(88f, _e3516, (_e3516 < 88f));
let _e3520 = ((_e3518 * 1.442695f) + 0.5f);
let _e3522 = select(-127f, _e3520, (_e3520 > -127f));
let _e3524 = select(128f, _e3522, (_e3522 < 128f));
let _e3531 = select(0i, select(select(i32(_e3524), i32(-2147483648), (_e3524 < -2147483600f)), 2147483647i, (_e3524 > 2147483500f)), (_e3524 == _e3524));
let _e3535 = (_e3531 - select(0i, 1i, (_e3524 < f32(_e3531))));
let _e3536 = f32(_e3535);
let _e3540 = ((_e3518 - (_e3536 * 0.6933594f)) - (_e3536 * -2.1219444e-4f));
let _e3561 = (_e3444 + 3i);
let _e3563 = select(_e3447, _e3561, (_e3561 < _e3447));
let _e3569 = global_4.member[bitcast<u32>(select(0i, _e3563, (_e3563 > 0i)))];
let _e3571 = -((_e3569 * _e3414));
let _e3573 = select(-87f, _e3571, (_e3571 > -87f));
let _e3575 = select(88f, _e3573, (_e3573 < 88f));
let _e3577 = ((_e3575 * 1.442695f) + 0.5f);
let _e3579 = select(-127f, _e3577, (_e3577 > -127f));
let _e3581 = select(128f, _e3579, (_e3579 < 128f));
let _e3588 = select(0i, select(select(i32(_e3581), i32(-2147483648), (_e3581 < -2147483600f)), 2147483647i, (_e3581 > 2147483500f)), (_e3581 == _e3581));
let _e3592 = (_e3588 - select(0i, 1i, (_e3581 < f32(_e3588))));
let _e3593 = f32(_e3592);
let _e3597 = ((_e3575 - (_e3593 * 0.6933594f)) - (_e3593 * -2.1219444e-4f));
phi_6091_ = type_20(_e3441.member, _e3441.member_1, vec3<f32>((_e832.member_2.x * ((1f + (_e3483 * (1f + (_e3483 * (0.5f + (_e3483 * (0.16666667f + (_e3483 * (0.041666668f + (_e3483 * (0.008333334f + (_e3483 * (0.001388889f + (_e3483 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3478 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.y * ((1f + (_e3540 * (1f + (_e3540 * (0.5f + (_e3540 * (0.16666667f + (_e3540 * (0.041666668f + (_e3540 * (0.008333334f + (_e3540 * (0.001388889f + (_e3540 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3535 + 127i)) << bitcast<u32>(23i))))), (_e832.member_2.z * ((1f + (_e3597 * (1f + (_e3597 * (0.5f + (_e3597 * (0.16666667f + (_e3597 * (0.041666668f + (_e3597 * (0.008333334f + (_e3597 * (0.001388889f + (_e3597 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3592 + 127i)) << bitcast<u32>(23i)))))), _e3441.member_3, _e3441.member_4, _e3441.member_5, _e3441.member_6, _e3441.member_7, _e3441.member_8, _e3441.member_9, _e3441.member_10, _e3441.member_11, _e3441.member_12, _e3441.member_13, _e3441.member_14, _e3441.member_15, _e3441.member_16, _e3441.member_17, _e3441.member_18, _e3441.member_19, _e3441.member_20, _e3441.member_21);
} else {
phi_6091_ = _e832;
}
let _e3651 = phi_6091_;
let _e3691 = type_20(vec3<f32>((_e3651.member.x + (_e3651.member_1.x * _e3651.member_21)), (_e3651.member.y + (_e3651.member_1.y * _e3651.member_21)), (_e3651.member.z + (_e3651.member_1.z * _e3651.member_21))), _e3651.member_1, _e3651.member_2, _e3651.member_3, _e3651.member_4, _e3651.member_5, _e3651.member_6, _e3651.member_7, _e3651.member_8, _e3651.member_9, _e3651.member_10, _e3651.member_11, _e3651.member_12, _e3651.member_13, _e3651.member_14, _e3651.member_15, _e3651.member_16, _e3651.member_17, _e3651.member_18, _e3651.member_19, _e3651.member_20, _e3651.member_21);
let _e3715 = type_20(_e3691.member, _e3691.member_1, _e3691.member_2, _e3691.member_3, _e3691.member_4, (_e3651.member_5 + _e3651.member_21), _e3691.member_6, _e3691.member_7, _e3691.member_8, _e3691.member_9, _e3691.member_10, _e3691.member_11, _e3691.member_12, _e3691.member_13, _e3691.member_14, _e3691.member_15, _e3691.member_16, _e3691.member_17, _e3691.member_18, _e3691.member_19, _e3691.member_20, _e3691.member_21);
let _e3738 = type_20(_e3715.member, _e3715.member_1, _e3715.member_2, _e3715.member_3, _e3715.member_4, _e3715.member_5, _e3715.member_6, _e3715.member_7, _e3715.member_8, _e3715.member_9, _e3715.member_10, _e3715.member_11, _e3715.member_12, _e3715.member_13, _e3715.member_14, _e3715.member_15, _e3715.member_16, _e3715.member_17, _e3715.member_18, _e3715.member_19, _e3715.member_20, (_e3651.member_21 - _e3651.member_21));
let _e3765 = type_20(_e3738.member, _e3738.member_1, _e3738.member_2, _e3738.member_3, _e3738.member_4, _e3738.member_5, _e3738.member_6, _e3738.member_7, _e3738.member_8, _e3738.member_9, (_e3651.member_10 + select(0f, _e3651.member_21, (_e3651.member_8 == 0f))), _e3738.member_11, _e3738.member_12, _e3738.member_13, _e3738.member_14, _e3738.member_15, _e3738.member_16, _e3738.member_17, _e3738.member_18, _e3738.member_19, _e3738.member_20, _e3738.member_21);
phi_6379_ = _e830;
phi_6380_ = type_20(_e3765.member, _e3765.member_1, _e3765.member_2, _e3765.member_3, _e3765.member_4, _e3765.member_5, 3f, _e3765.member_7, _e3765.member_8, _e3765.member_9, _e3765.member_10, _e3765.member_11, _e3765.member_12, _e3765.member_13, _e3765.member_14, _e3765.member_15, _e3765.member_16, _e3765.member_17, _e3765.member_18, _e3765.member_19, _e3765.member_20, _e3765.member_21);
} else {
phi_6379_ = _e3237;
phi_6380_ = _e3239;
}
let _e3789 = phi_6379_;
let _e3791 = phi_6380_;
let _e3793 = select(select(_e3245, false, _e895), true, _e3408);
if _e3793 {
phi_6386_ = _e3789;
phi_6387_ = _e3791;
} else {
phi_6386_ = _e830;
phi_6387_ = _e3407;
}
let _e3795 = phi_6386_;
let _e3797 = phi_6387_;
phi_6389_ = _e3795;
phi_6390_ = _e3797;
phi_6391_ = select(_e836, select(_e3241, _e836, _e3408), _e3793);
}
let _e4446 = phi_6389_;
let _e4448 = phi_6390_;
let _e4450 = phi_6391_;
phi_1326_ = _e4446;
phi_1329_ = _e4448;
phi_1331_ = (_e834 + 1i);
phi_1333_ = _e4450;
} else {
phi_1326_ = type_21();
phi_1329_ = type_20();
phi_1331_ = i32();
phi_1333_ = i32();
}
let _e4452 = phi_1326_;
let _e4454 = phi_1329_;
let _e4456 = phi_1331_;
let _e4458 = phi_1333_;
continue;
continuing {
phi_1325_ = _e4452;
phi_1328_ = _e4454;
phi_1330_ = _e4456;
phi_1332_ = _e4458;
break if !(_e840);
}
}
let _e4461 = local_13;
if (_e4461 == 0i) {
phi_6397_ = 16i;
} else {
let _e4464 = local_14;
phi_6397_ = -(_e4464);
}
let _e4467 = phi_6397_;
let _e4469 = local_15;
let _e4473 = local_16;
let _e4477 = local_17;
let _e4480 = local_18;
let _e4483 = local_19;
let _e4487 = local_20;
let _e4491 = local_21;
let _e4495 = local_22;
let _e4499 = local_23;
let _e4503 = local_24;
let _e4507 = local_25;
let _e4511 = local_26;
let _e4515 = local_27;
let _e4519 = local_28;
let _e4523 = local_29;
let _e4527 = local_30;
let _e4532 = local_31;
let _e4535 = local_32;
let _e4538 = local_33;
let _e4541 = local_34;
let _e4544 = local_35;
let _e4548 = local_36;
let _e4552 = local_37;
let _e4556 = local_38;
let _e4560 = local_39;
let _e4564 = local_40;
let _e4568 = local_41;
let _e4572 = local_42;
let _e4576 = local_43;
let _e4580 = local_44;
let _e4584 = local_45;
let _e4588 = local_46;
let _e4592 = local_47;
let _e4596 = local_48;
let _e4600 = local_49;
let _e4604 = local_50;
let _e4608 = local_51;
let _e4612 = local_52;
let _e4616 = local_53;
global_5.member[_e138] = _e4483.member.x;
global_5.member[_e150] = _e4487.member.y;
global_5.member[_e161] = _e4491.member.z;
global_5.member[_e172] = _e4495.member_1.x;
global_5.member[_e183] = _e4499.member_1.y;
global_5.member[_e194] = _e4503.member_1.z;
global_5.member[_e205] = _e4507.member_2.x;
global_5.member[_e216] = _e4511.member_2.y;
global_5.member[_e227] = _e4515.member_2.z;
global_5.member[_e238] = _e4519.member_3.x;
global_5.member[_e249] = _e4523.member_3.y;
global_5.member[_e260] = _e4527.member_3.z;
global_5.member[_e271] = f32(_e4469.member);
global_5.member[_e282] = f32(_e4473.member_1);
global_5.member[_e293] = _e4477.member_2;
global_5.member[_e304] = _e4480.member_3;
let _e4653 = local_54;
global_5.member[_e315] = _e4653;
global_5.member[_e326] = f32(_e4467);
global_5.member[_e337] = _e4532.member_8;
global_5.member[_e348] = _e4535.member_9;
global_5.member[_e359] = _e4538.member_10;
global_5.member[_e370] = _e4541.member_11;
global_5.member[_e381] = _e4544.member_12.x;
global_5.member[_e392] = _e4548.member_12.y;
global_5.member[_e403] = _e4552.member_12.z;
global_5.member[_e414] = _e4556.member_13.x;
global_5.member[_e425] = _e4560.member_13.y;
global_5.member[_e436] = _e4564.member_13.z;
global_5.member[_e447] = _e4568.member_14.x;
global_5.member[_e458] = _e4572.member_14.y;
global_5.member[_e469] = _e4576.member_14.z;
global_5.member[_e480] = 0f;
global_5.member[_e491] = 0f;
global_5.member[_e502] = 0f;
global_5.member[_e513] = _e4580.member_16.x;
global_5.member[_e524] = _e4584.member_16.y;
global_5.member[_e535] = _e4588.member_16.z;
global_5.member[_e546] = _e4592.member_17.x;
global_5.member[_e557] = _e4596.member_17.y;
global_5.member[_e568] = _e4600.member_17.z;
global_5.member[_e579] = f32(_e4604.member_18);
global_5.member[_e590] = f32(_e4608.member_19);
global_5.member[_e601] = f32(_e4612.member_20);
global_5.member[_e612] = _e4616.member_21;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
