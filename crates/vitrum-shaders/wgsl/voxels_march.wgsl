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
struct type_22 {
member: array<u32>,
}
struct type_25 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_22;
@group(0) @binding(2)
var<storage> global_5: type_22;
@group(0) @binding(5)
var<storage, read_write> global_6: type_25;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_1014_: u32;
var phi_1114_: i32;
var phi_1117_: i32;
var phi_1553_: f32;
var phi_1115_: i32;
var phi_1118_: i32;
var local_2: i32;
var phi_1561_: type_20;
var phi_1563_: type_20;
var phi_1566_: i32;
var phi_1902_: f32;
var phi_1940_: i32;
var phi_1943_: i32;
var phi_2379_: f32;
var phi_1941_: i32;
var phi_1944_: i32;
var local_3: i32;
var phi_2391_: i32;
var phi_2394_: f32;
var phi_2396_: f32;
var phi_2425_: i32;
var phi_2428_: i32;
var phi_2864_: f32;
var phi_2426_: i32;
var phi_2429_: i32;
var local_4: i32;
var phi_2392_: i32;
var phi_2395_: f32;
var phi_2397_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2899_: i32;
var phi_2902_: i32;
var phi_3338_: f32;
var phi_2900_: i32;
var phi_2903_: i32;
var local_8: i32;
var local_9: i32;
var phi_3798_: f32;
var phi_4237_: f32;
var phi_4677_: f32;
var phi_5116_: f32;
var phi_5556_: f32;
var phi_5995_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_6325_: type_20;
var local_17: i32;
var local_18: i32;
var phi_6544_: type_20;
var phi_6916_: type_20;
var phi_6917_: type_20;
var phi_6970_: type_20;
var phi_6984_: type_20;
var local_19: i32;
var phi_7429_: type_20;
var phi_7430_: type_20;
var phi_7410_: type_20;
var phi_7431_: type_20;
var local_20: i32;
var phi_7439_: type_20;
var phi_7440_: type_20;
var phi_7441_: bool;
var phi_8020_: type_20;
var local_21: i32;
var phi_8322_: type_20;
var phi_8323_: type_20;
var phi_8324_: type_20;
var phi_7731_: type_20;
var phi_8325_: type_20;
var phi_1564_: type_20;
var phi_1567_: i32;
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
var local_54: type_20;
var local_55: type_20;
var local_56: type_20;
var local_57: type_20;
var local_58: type_20;
var local_59: type_20;
var local_60: type_20;
var local_61: type_20;
var local_62: type_20;
var local_63: type_20;
var local_64: type_20;
var local_65: f32;
let _e104 = global;
let _e110 = arrayLength((&global_5.member));
let _e112 = arrayLength((&global_2.member));
let _e119 = global_1.member.member;
if (_e104.x < _e119.member) {
if (_e104.y < _e119.member_1) {
let _e126 = (_e119.member * _e119.member_1);
let _e128 = ((_e104.y * _e119.member) + _e104.x);
let _e129 = bitcast<i32>(_e128);
let _e131 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e133 = select(_e131, _e129, (_e129 < _e131));
let _e139 = global_3.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e140 = (_e126 + _e128);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e131, _e141, (_e141 < _e131));
let _e149 = global_3.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((2u * _e126) + _e128);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e131, _e152, (_e152 < _e131));
let _e160 = global_3.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((3u * _e126) + _e128);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e131, _e163, (_e163 < _e131));
let _e171 = global_3.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((4u * _e126) + _e128);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e131, _e174, (_e174 < _e131));
let _e182 = global_3.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((5u * _e126) + _e128);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e131, _e185, (_e185 < _e131));
let _e193 = global_3.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((6u * _e126) + _e128);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e131, _e196, (_e196 < _e131));
let _e204 = global_3.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((7u * _e126) + _e128);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e131, _e207, (_e207 < _e131));
let _e215 = global_3.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((8u * _e126) + _e128);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e131, _e218, (_e218 < _e131));
let _e226 = global_3.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((9u * _e126) + _e128);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e131, _e229, (_e229 < _e131));
let _e237 = global_3.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((10u * _e126) + _e128);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e131, _e240, (_e240 < _e131));
let _e248 = global_3.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((11u * _e126) + _e128);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e131, _e251, (_e251 < _e131));
let _e259 = global_3.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((12u * _e126) + _e128);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e131, _e262, (_e262 < _e131));
let _e270 = global_3.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((13u * _e126) + _e128);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e131, _e273, (_e273 < _e131));
let _e281 = global_3.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((14u * _e126) + _e128);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e131, _e284, (_e284 < _e131));
let _e292 = global_3.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((15u * _e126) + _e128);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e131, _e295, (_e295 < _e131));
let _e303 = global_3.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((16u * _e126) + _e128);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e131, _e306, (_e306 < _e131));
let _e314 = global_3.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((17u * _e126) + _e128);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e131, _e317, (_e317 < _e131));
let _e325 = global_3.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((18u * _e126) + _e128);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e131, _e328, (_e328 < _e131));
let _e336 = global_3.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((19u * _e126) + _e128);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e131, _e339, (_e339 < _e131));
let _e347 = global_3.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e349 = ((20u * _e126) + _e128);
let _e350 = bitcast<i32>(_e349);
let _e352 = select(_e131, _e350, (_e350 < _e131));
let _e358 = global_3.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e360 = ((21u * _e126) + _e128);
let _e361 = bitcast<i32>(_e360);
let _e363 = select(_e131, _e361, (_e361 < _e131));
let _e369 = global_3.member[bitcast<u32>(select(0i, _e363, (_e363 > 0i)))];
let _e371 = ((22u * _e126) + _e128);
let _e372 = bitcast<i32>(_e371);
let _e374 = select(_e131, _e372, (_e372 < _e131));
let _e380 = global_3.member[bitcast<u32>(select(0i, _e374, (_e374 > 0i)))];
let _e382 = ((23u * _e126) + _e128);
let _e383 = bitcast<i32>(_e382);
let _e385 = select(_e131, _e383, (_e383 < _e131));
let _e391 = global_3.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e393 = ((24u * _e126) + _e128);
let _e394 = bitcast<i32>(_e393);
let _e396 = select(_e131, _e394, (_e394 < _e131));
let _e402 = global_3.member[bitcast<u32>(select(0i, _e396, (_e396 > 0i)))];
let _e404 = ((25u * _e126) + _e128);
let _e405 = bitcast<i32>(_e404);
let _e407 = select(_e131, _e405, (_e405 < _e131));
let _e413 = global_3.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e415 = ((26u * _e126) + _e128);
let _e416 = bitcast<i32>(_e415);
let _e418 = select(_e131, _e416, (_e416 < _e131));
let _e424 = global_3.member[bitcast<u32>(select(0i, _e418, (_e418 > 0i)))];
let _e426 = ((27u * _e126) + _e128);
let _e427 = bitcast<i32>(_e426);
let _e429 = select(_e131, _e427, (_e427 < _e131));
let _e435 = global_3.member[bitcast<u32>(select(0i, _e429, (_e429 > 0i)))];
let _e437 = ((28u * _e126) + _e128);
let _e438 = bitcast<i32>(_e437);
let _e440 = select(_e131, _e438, (_e438 < _e131));
let _e446 = global_3.member[bitcast<u32>(select(0i, _e440, (_e440 > 0i)))];
let _e448 = ((29u * _e126) + _e128);
let _e449 = bitcast<i32>(_e448);
let _e451 = select(_e131, _e449, (_e449 < _e131));
let _e457 = global_3.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e459 = ((30u * _e126) + _e128);
let _e460 = bitcast<i32>(_e459);
let _e462 = select(_e131, _e460, (_e460 < _e131));
let _e468 = global_3.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e470 = ((31u * _e126) + _e128);
let _e471 = bitcast<i32>(_e470);
let _e473 = select(_e131, _e471, (_e471 < _e131));
let _e479 = global_3.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e481 = ((32u * _e126) + _e128);
let _e482 = bitcast<i32>(_e481);
let _e484 = select(_e131, _e482, (_e482 < _e131));
let _e490 = global_3.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e492 = ((33u * _e126) + _e128);
let _e493 = bitcast<i32>(_e492);
let _e495 = select(_e131, _e493, (_e493 < _e131));
let _e501 = global_3.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e503 = ((34u * _e126) + _e128);
let _e504 = bitcast<i32>(_e503);
let _e506 = select(_e131, _e504, (_e504 < _e131));
let _e512 = global_3.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e514 = ((35u * _e126) + _e128);
let _e515 = bitcast<i32>(_e514);
let _e517 = select(_e131, _e515, (_e515 < _e131));
let _e523 = global_3.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e525 = ((36u * _e126) + _e128);
let _e526 = bitcast<i32>(_e525);
let _e528 = select(_e131, _e526, (_e526 < _e131));
let _e534 = global_3.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e536 = ((37u * _e126) + _e128);
let _e537 = bitcast<i32>(_e536);
let _e539 = select(_e131, _e537, (_e537 < _e131));
let _e545 = global_3.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e547 = ((38u * _e126) + _e128);
let _e548 = bitcast<i32>(_e547);
let _e550 = select(_e131, _e548, (_e548 < _e131));
let _e556 = global_3.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e558 = ((39u * _e126) + _e128);
let _e559 = bitcast<i32>(_e558);
let _e561 = select(_e131, _e559, (_e559 < _e131));
let _e567 = global_3.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e569 = ((40u * _e126) + _e128);
let _e570 = bitcast<i32>(_e569);
let _e572 = select(_e131, _e570, (_e570 < _e131));
let _e578 = global_3.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e580 = ((41u * _e126) + _e128);
let _e581 = bitcast<i32>(_e580);
let _e583 = select(_e131, _e581, (_e581 < _e131));
let _e589 = global_3.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e591 = ((42u * _e126) + _e128);
let _e592 = bitcast<i32>(_e591);
let _e594 = select(_e131, _e592, (_e592 < _e131));
let _e600 = global_3.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e602 = ((43u * _e126) + _e128);
let _e603 = bitcast<i32>(_e602);
let _e605 = select(_e131, _e603, (_e603 < _e131));
let _e611 = global_3.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e612 = (_e314 == 0f);
if _e612 {
phi_1014_ = 3u;
} else {
phi_1014_ = select(0u, 1u, (_e314 == 4f));
}
let _e616 = phi_1014_;
if (_e616 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e625 = atomicLoad((&global_6.member[0u]));
if (_e625 == 0u) {
atomicStore((&global_6.member[0u]), ((_e119.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e119.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e616 > 1u) {
let _e633 = vec3<f32>(_e139, _e149, _e160);
let _e634 = vec3<f32>(_e171, _e182, _e193);
let _e635 = vec3<f32>(_e204, _e215, _e226);
let _e636 = vec3<f32>(_e237, _e248, _e259);
let _e637 = vec3<f32>(_e270, _e281, _e292);
let _e645 = vec3<f32>(_e380, _e391, _e402);
let _e646 = vec3<f32>(_e413, _e424, _e435);
let _e647 = vec3<f32>(_e446, _e457, _e468);
let _e648 = vec3<f32>(_e479, _e490, _e501);
let _e649 = vec3<f32>(_e512, _e523, _e534);
let _e650 = vec3<f32>(_e545, _e556, _e567);
let _e657 = select(0i, select(select(i32(_e578), i32(-2147483648), (_e578 < -2147483600f)), 2147483647i, (_e578 > 2147483500f)), (_e578 == _e578));
let _e664 = select(0i, select(select(i32(_e589), i32(-2147483648), (_e589 < -2147483600f)), 2147483647i, (_e589 > 2147483500f)), (_e589 == _e589));
let _e671 = select(0i, select(select(i32(_e600), i32(-2147483648), (_e600 < -2147483600f)), 2147483647i, (_e600 > 2147483500f)), (_e600 == _e600));
let _e675 = global_1.member.member_14;
let _e681 = global_1.member.member_15;
if (_e612 && (_e336 == 0f)) {
let _e689 = global_1.member.member_3;
phi_1114_ = (bitcast<i32>(_e689) - 1i);
phi_1117_ = 16i;
loop {
let _e693 = phi_1114_;
let _e695 = phi_1117_;
local_2 = _e695;
let _e696 = (_e693 >= 0i);
if _e696 {
let _e700 = global_1.member.member_2.member;
let _e705 = global_1.member.member_2.member_1;
let _e710 = global_1.member.member_2.member_2;
let _e712 = (_e139 - 0.5f);
let _e713 = (_e149 - 0.5f);
let _e714 = (_e160 - 0.5f);
let _e716 = f32((bitcast<i32>(_e700) - 2i));
let _e718 = select(0f, _e712, (_e712 > 0f));
let _e720 = select(_e716, _e718, (_e718 < _e716));
let _e727 = select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < -2147483600f)), 2147483647i, (_e720 > 2147483500f)), (_e720 == _e720));
let _e731 = (_e727 - select(0i, 1i, (_e720 < f32(_e727))));
let _e733 = f32((bitcast<i32>(_e705) - 2i));
let _e735 = select(0f, _e713, (_e713 > 0f));
let _e737 = select(_e733, _e735, (_e735 < _e733));
let _e744 = select(0i, select(select(i32(_e737), i32(-2147483648), (_e737 < -2147483600f)), 2147483647i, (_e737 > 2147483500f)), (_e737 == _e737));
let _e748 = (_e744 - select(0i, 1i, (_e737 < f32(_e744))));
let _e750 = f32((bitcast<i32>(_e710) - 2i));
let _e752 = select(0f, _e714, (_e714 > 0f));
let _e754 = select(_e750, _e752, (_e752 < _e750));
let _e761 = select(0i, select(select(i32(_e754), i32(-2147483648), (_e754 < -2147483600f)), 2147483647i, (_e754 > 2147483500f)), (_e754 == _e754));
let _e765 = (_e761 - select(0i, 1i, (_e754 < f32(_e761))));
let _e766 = (_e693 * 4i);
let _e767 = (_e766 + 1i);
let _e769 = (bitcast<i32>(_e110) - 1i);
let _e771 = select(_e769, _e767, (_e767 < _e769));
let _e777 = global_5.member[bitcast<u32>(select(0i, _e771, (_e771 > 0i)))];
let _e778 = (_e766 + 2i);
let _e780 = select(_e769, _e778, (_e778 < _e769));
let _e786 = global_5.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e787 = (_e766 + 3i);
let _e789 = select(_e769, _e787, (_e787 < _e769));
let _e795 = global_5.member[bitcast<u32>(select(0i, _e789, (_e789 > 0i)))];
let _e798 = (_e731 - bitcast<i32>((_e777 & 65535u)));
let _e803 = bitcast<i32>((_e777 >> bitcast<u32>(16i)));
let _e808 = (_e748 - bitcast<i32>((_e786 & 65535u)));
let _e813 = bitcast<i32>((_e786 >> bitcast<u32>(16i)));
let _e818 = (_e765 - bitcast<i32>((_e795 & 65535u)));
if ((((_e798 >= 0i) && ((_e798 + 1i) < _e803)) && ((_e808 >= 0i) && ((_e808 + 1i) < _e813))) && ((_e818 >= 0i) && ((_e818 + 1i) < bitcast<i32>((_e795 >> bitcast<u32>(16i)))))) {
let _e828 = (_e813 * _e803);
let _e830 = select(_e769, _e766, (_e766 < _e769));
let _e836 = global_5.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e842 = (((bitcast<i32>(_e836) + (_e818 * _e828)) + (_e808 * _e803)) + _e798);
let _e844 = (_e712 - f32(_e731));
let _e846 = (_e713 - f32(_e748));
let _e849 = (2i * _e842);
let _e851 = (_e849 >> bitcast<u32>(2i));
let _e854 = bitcast<u32>(((_e849 & 3i) * 8i));
let _e856 = select(_e769, _e851, (_e851 < _e769));
let _e862 = global_5.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e866 = (_e851 + 1i);
let _e868 = select(_e769, _e866, (_e866 < _e769));
let _e874 = global_5.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
let _e881 = ((_e862 >> bitcast<u32>((_e854 & 31u))) | ((_e874 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e854) & 31u))));
let _e884 = f32(bitcast<i32>((_e881 & 65535u)));
let _e891 = (_e884 + ((f32(bitcast<i32>((_e881 >> bitcast<u32>(16i)))) - _e884) * _e844));
let _e893 = (2i * (_e842 + _e803));
let _e895 = (_e893 >> bitcast<u32>(2i));
let _e898 = bitcast<u32>(((_e893 & 3i) * 8i));
let _e900 = select(_e769, _e895, (_e895 < _e769));
let _e906 = global_5.member[bitcast<u32>(select(0i, _e900, (_e900 > 0i)))];
let _e910 = (_e895 + 1i);
let _e912 = select(_e769, _e910, (_e910 < _e769));
let _e918 = global_5.member[bitcast<u32>(select(0i, _e912, (_e912 > 0i)))];
let _e925 = ((_e906 >> bitcast<u32>((_e898 & 31u))) | ((_e918 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e898) & 31u))));
let _e928 = f32(bitcast<i32>((_e925 & 65535u)));
let _e936 = (_e842 + _e828);
let _e937 = (2i * _e936);
let _e939 = (_e937 >> bitcast<u32>(2i));
let _e942 = bitcast<u32>(((_e937 & 3i) * 8i));
let _e944 = select(_e769, _e939, (_e939 < _e769));
let _e950 = global_5.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
let _e954 = (_e939 + 1i);
let _e956 = select(_e769, _e954, (_e954 < _e769));
let _e962 = global_5.member[bitcast<u32>(select(0i, _e956, (_e956 > 0i)))];
let _e969 = ((_e950 >> bitcast<u32>((_e942 & 31u))) | ((_e962 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e942) & 31u))));
let _e972 = f32(bitcast<i32>((_e969 & 65535u)));
let _e979 = (_e972 + ((f32(bitcast<i32>((_e969 >> bitcast<u32>(16i)))) - _e972) * _e844));
let _e981 = (2i * (_e936 + _e803));
let _e983 = (_e981 >> bitcast<u32>(2i));
let _e986 = bitcast<u32>(((_e981 & 3i) * 8i));
let _e988 = select(_e769, _e983, (_e983 < _e769));
let _e994 = global_5.member[bitcast<u32>(select(0i, _e988, (_e988 > 0i)))];
let _e998 = (_e983 + 1i);
let _e1000 = select(_e769, _e998, (_e998 < _e769));
let _e1006 = global_5.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1013 = ((_e994 >> bitcast<u32>((_e986 & 31u))) | ((_e1006 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e986) & 31u))));
let _e1016 = f32(bitcast<i32>((_e1013 & 65535u)));
let _e1026 = (_e891 + (((_e928 + ((f32(bitcast<i32>((_e925 >> bitcast<u32>(16i)))) - _e928) * _e844)) - _e891) * _e846));
phi_1553_ = (_e1026 + (((_e979 + (((_e1016 + ((f32(bitcast<i32>((_e1013 >> bitcast<u32>(16i)))) - _e1016) * _e844)) - _e979) * _e846)) - _e1026) * (_e714 - f32(_e765))));
} else {
phi_1553_ = 0f;
}
let _e1034 = phi_1553_;
phi_1115_ = (_e693 - 1i);
phi_1118_ = select(_e695, _e693, (_e1034 > 32767.5f));
} else {
phi_1115_ = i32();
phi_1118_ = i32();
}
let _e1039 = phi_1115_;
let _e1041 = phi_1118_;
continue;
continuing {
phi_1114_ = _e1039;
phi_1117_ = _e1041;
break if !(_e696);
}
}
let _e1044 = local_2;
phi_1561_ = type_20(_e633, _e634, _e635, _e636, _e637, _e303, _e314, _e1044, _e336, _e347, _e358, _e369, _e645, _e646, _e647, _e648, _e649, _e650, _e657, _e664, _e671, _e611);
} else {
phi_1561_ = type_20(_e633, _e634, _e635, _e636, _e637, _e303, _e314, select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < -2147483600f)), 2147483647i, (_e325 > 2147483500f)), (_e325 == _e325)), _e336, _e347, _e358, _e369, _e645, _e646, _e647, _e648, _e649, _e650, _e657, _e664, _e671, _e611);
}
let _e1047 = phi_1561_;
phi_1563_ = _e1047;
phi_1566_ = 0i;
loop {
let _e1049 = phi_1563_;
let _e1051 = phi_1566_;
local_22 = _e1049;
local_23 = _e1049;
local_24 = _e1049;
local_25 = _e1049;
local_26 = _e1049;
local_27 = _e1049;
local_28 = _e1049;
local_29 = _e1049;
local_30 = _e1049;
local_31 = _e1049;
local_32 = _e1049;
local_33 = _e1049;
local_34 = _e1049;
local_35 = _e1049;
local_36 = _e1049;
local_37 = _e1049;
local_38 = _e1049;
local_39 = _e1049;
local_40 = _e1049;
local_41 = _e1049;
local_42 = _e1049;
local_43 = _e1049;
local_44 = _e1049;
local_45 = _e1049;
local_46 = _e1049;
local_47 = _e1049;
local_48 = _e1049;
local_49 = _e1049;
local_50 = _e1049;
local_51 = _e1049;
local_52 = _e1049;
local_53 = _e1049;
local_54 = _e1049;
local_55 = _e1049;
local_56 = _e1049;
local_57 = _e1049;
local_58 = _e1049;
local_59 = _e1049;
local_60 = _e1049;
local_61 = _e1049;
local_62 = _e1049;
local_63 = _e1049;
local_64 = _e1049;
let _e1055 = ((_e1051 < 256i) && (_e1049.member_6 == 0f));
local_65 = _e1049.member_6;
if _e1055 {
let _e1066 = (1f / select(_e1049.member_1.x, select(1e-12f, -1e-12f, (_e1049.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1049.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1075 = (1f / select(_e1049.member_1.y, select(1e-12f, -1e-12f, (_e1049.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1049.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1084 = (1f / select(_e1049.member_1.z, select(1e-12f, -1e-12f, (_e1049.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1049.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1088 = ((_e675.member - _e1049.member.x) * _e1066);
let _e1090 = ((_e681.member - _e1049.member.x) * _e1066);
let _e1093 = ((_e675.member_1 - _e1049.member.y) * _e1075);
let _e1095 = ((_e681.member_1 - _e1049.member.y) * _e1075);
let _e1098 = ((_e675.member_2 - _e1049.member.z) * _e1084);
let _e1100 = ((_e681.member_2 - _e1049.member.z) * _e1084);
let _e1102 = select(_e1090, _e1088, (_e1088 > _e1090));
let _e1104 = select(_e1095, _e1093, (_e1093 > _e1095));
let _e1106 = select(_e1104, _e1102, (_e1102 < _e1104));
let _e1108 = select(_e1100, _e1098, (_e1098 > _e1100));
let _e1110 = select(_e1108, _e1106, (_e1106 < _e1108));
let _e1114 = global_1.member.member_4.member;
let _e1115 = bitcast<i32>(_e1114);
let _e1119 = global_1.member.member_4.member_1;
let _e1120 = bitcast<i32>(_e1119);
let _e1124 = global_1.member.member_4.member_2;
let _e1127 = ((_e1049.member.x - 0.5f) / 4f);
let _e1129 = f32((_e1115 - 1i));
let _e1131 = select(0f, _e1127, (_e1127 > 0f));
let _e1133 = select(_e1129, _e1131, (_e1131 < _e1129));
let _e1140 = select(0i, select(select(i32(_e1133), i32(-2147483648), (_e1133 < -2147483600f)), 2147483647i, (_e1133 > 2147483500f)), (_e1133 == _e1133));
let _e1144 = (_e1140 - select(0i, 1i, (_e1133 < f32(_e1140))));
let _e1146 = ((_e1049.member.y - 0.5f) / 4f);
let _e1148 = f32((_e1120 - 1i));
let _e1150 = select(0f, _e1146, (_e1146 > 0f));
let _e1152 = select(_e1148, _e1150, (_e1150 < _e1148));
let _e1159 = select(0i, select(select(i32(_e1152), i32(-2147483648), (_e1152 < -2147483600f)), 2147483647i, (_e1152 > 2147483500f)), (_e1152 == _e1152));
let _e1163 = (_e1159 - select(0i, 1i, (_e1152 < f32(_e1159))));
let _e1165 = ((_e1049.member.z - 0.5f) / 4f);
let _e1167 = f32((bitcast<i32>(_e1124) - 1i));
let _e1169 = select(0f, _e1165, (_e1165 > 0f));
let _e1171 = select(_e1167, _e1169, (_e1169 < _e1167));
let _e1178 = select(0i, select(select(i32(_e1171), i32(-2147483648), (_e1171 < -2147483600f)), 2147483647i, (_e1171 > 2147483500f)), (_e1171 == _e1171));
let _e1182 = (_e1178 - select(0i, 1i, (_e1171 < f32(_e1178))));
let _e1186 = ((((_e1182 * _e1120) + _e1163) * _e1115) + _e1144);
let _e1188 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1190 = select(_e1188, _e1186, (_e1186 < _e1188));
let _e1196 = global_4.member[bitcast<u32>(select(0i, _e1190, (_e1190 > 0i)))];
let _e1197 = bitcast<i32>(_e1196);
if (_e1197 > 0i) {
let _e1227 = ((((f32(((_e1144 - _e1197) + 1i)) * 4f) + 0.5f) - _e1049.member.x) * _e1066);
let _e1229 = ((((f32((_e1144 + _e1197)) * 4f) + 0.5f) - _e1049.member.x) * _e1066);
let _e1231 = ((((f32(((_e1163 - _e1197) + 1i)) * 4f) + 0.5f) - _e1049.member.y) * _e1075);
let _e1233 = ((((f32((_e1163 + _e1197)) * 4f) + 0.5f) - _e1049.member.y) * _e1075);
let _e1235 = ((((f32(((_e1182 - _e1197) + 1i)) * 4f) + 0.5f) - _e1049.member.z) * _e1084);
let _e1237 = ((((f32((_e1182 + _e1197)) * 4f) + 0.5f) - _e1049.member.z) * _e1084);
let _e1239 = select(_e1229, _e1227, (_e1227 > _e1229));
let _e1241 = select(_e1233, _e1231, (_e1231 > _e1233));
let _e1243 = select(_e1241, _e1239, (_e1239 < _e1241));
let _e1245 = select(_e1237, _e1235, (_e1235 > _e1237));
let _e1247 = select(_e1245, _e1243, (_e1243 < _e1245));
phi_1902_ = (select(0f, _e1247, (_e1247 > 0f)) + 1e-3f);
} else {
phi_1902_ = 0.5f;
}
let _e1252 = phi_1902_;
let _e1255 = (select(0f, _e1110, (_e1110 > 0f)) + 1e-3f);
let _e1257 = select(_e1255, _e1252, (_e1252 < _e1255));
let _e1259 = (_e1049.member_21 <= _e1257);
let _e1260 = select(_e1257, _e1049.member_21, _e1259);
let _e1270 = global_1.member.member_3;
let _e1272 = (bitcast<i32>(_e1270) - 1i);
phi_1940_ = _e1272;
phi_1943_ = 16i;
loop {
let _e1274 = phi_1940_;
let _e1276 = phi_1943_;
local_3 = _e1276;
local_21 = _e1276;
let _e1277 = (_e1274 >= 0i);
if _e1277 {
let _e1281 = global_1.member.member_2.member;
let _e1286 = global_1.member.member_2.member_1;
let _e1291 = global_1.member.member_2.member_2;
let _e1293 = ((_e1049.member.x + (_e1049.member_1.x * _e1260)) - 0.5f);
let _e1294 = ((_e1049.member.y + (_e1049.member_1.y * _e1260)) - 0.5f);
let _e1295 = ((_e1049.member.z + (_e1049.member_1.z * _e1260)) - 0.5f);
let _e1297 = f32((bitcast<i32>(_e1281) - 2i));
let _e1299 = select(0f, _e1293, (_e1293 > 0f));
let _e1301 = select(_e1297, _e1299, (_e1299 < _e1297));
let _e1308 = select(0i, select(select(i32(_e1301), i32(-2147483648), (_e1301 < -2147483600f)), 2147483647i, (_e1301 > 2147483500f)), (_e1301 == _e1301));
let _e1312 = (_e1308 - select(0i, 1i, (_e1301 < f32(_e1308))));
let _e1314 = f32((bitcast<i32>(_e1286) - 2i));
let _e1316 = select(0f, _e1294, (_e1294 > 0f));
let _e1318 = select(_e1314, _e1316, (_e1316 < _e1314));
let _e1325 = select(0i, select(select(i32(_e1318), i32(-2147483648), (_e1318 < -2147483600f)), 2147483647i, (_e1318 > 2147483500f)), (_e1318 == _e1318));
let _e1329 = (_e1325 - select(0i, 1i, (_e1318 < f32(_e1325))));
let _e1331 = f32((bitcast<i32>(_e1291) - 2i));
let _e1333 = select(0f, _e1295, (_e1295 > 0f));
let _e1335 = select(_e1331, _e1333, (_e1333 < _e1331));
let _e1342 = select(0i, select(select(i32(_e1335), i32(-2147483648), (_e1335 < -2147483600f)), 2147483647i, (_e1335 > 2147483500f)), (_e1335 == _e1335));
let _e1346 = (_e1342 - select(0i, 1i, (_e1335 < f32(_e1342))));
let _e1347 = (_e1274 * 4i);
let _e1348 = (_e1347 + 1i);
let _e1350 = (bitcast<i32>(_e110) - 1i);
let _e1352 = select(_e1350, _e1348, (_e1348 < _e1350));
let _e1358 = global_5.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1359 = (_e1347 + 2i);
let _e1361 = select(_e1350, _e1359, (_e1359 < _e1350));
let _e1367 = global_5.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1368 = (_e1347 + 3i);
let _e1370 = select(_e1350, _e1368, (_e1368 < _e1350));
let _e1376 = global_5.member[bitcast<u32>(select(0i, _e1370, (_e1370 > 0i)))];
let _e1379 = (_e1312 - bitcast<i32>((_e1358 & 65535u)));
let _e1384 = bitcast<i32>((_e1358 >> bitcast<u32>(16i)));
let _e1389 = (_e1329 - bitcast<i32>((_e1367 & 65535u)));
let _e1394 = bitcast<i32>((_e1367 >> bitcast<u32>(16i)));
let _e1399 = (_e1346 - bitcast<i32>((_e1376 & 65535u)));
if ((((_e1379 >= 0i) && ((_e1379 + 1i) < _e1384)) && ((_e1389 >= 0i) && ((_e1389 + 1i) < _e1394))) && ((_e1399 >= 0i) && ((_e1399 + 1i) < bitcast<i32>((_e1376 >> bitcast<u32>(16i)))))) {
let _e1409 = (_e1394 * _e1384);
let _e1411 = select(_e1350, _e1347, (_e1347 < _e1350));
let _e1417 = global_5.member[bitcast<u32>(select(0i, _e1411, (_e1411 > 0i)))];
let _e1423 = (((bitcast<i32>(_e1417) + (_e1399 * _e1409)) + (_e1389 * _e1384)) + _e1379);
let _e1425 = (_e1293 - f32(_e1312));
let _e1427 = (_e1294 - f32(_e1329));
let _e1430 = (2i * _e1423);
let _e1432 = (_e1430 >> bitcast<u32>(2i));
let _e1435 = bitcast<u32>(((_e1430 & 3i) * 8i));
let _e1437 = select(_e1350, _e1432, (_e1432 < _e1350));
let _e1443 = global_5.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1447 = (_e1432 + 1i);
let _e1449 = select(_e1350, _e1447, (_e1447 < _e1350));
let _e1455 = global_5.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1462 = ((_e1443 >> bitcast<u32>((_e1435 & 31u))) | ((_e1455 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1435) & 31u))));
let _e1465 = f32(bitcast<i32>((_e1462 & 65535u)));
let _e1472 = (_e1465 + ((f32(bitcast<i32>((_e1462 >> bitcast<u32>(16i)))) - _e1465) * _e1425));
let _e1474 = (2i * (_e1423 + _e1384));
let _e1476 = (_e1474 >> bitcast<u32>(2i));
let _e1479 = bitcast<u32>(((_e1474 & 3i) * 8i));
let _e1481 = select(_e1350, _e1476, (_e1476 < _e1350));
let _e1487 = global_5.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1491 = (_e1476 + 1i);
let _e1493 = select(_e1350, _e1491, (_e1491 < _e1350));
let _e1499 = global_5.member[bitcast<u32>(select(0i, _e1493, (_e1493 > 0i)))];
let _e1506 = ((_e1487 >> bitcast<u32>((_e1479 & 31u))) | ((_e1499 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1479) & 31u))));
let _e1509 = f32(bitcast<i32>((_e1506 & 65535u)));
let _e1517 = (_e1423 + _e1409);
let _e1518 = (2i * _e1517);
let _e1520 = (_e1518 >> bitcast<u32>(2i));
let _e1523 = bitcast<u32>(((_e1518 & 3i) * 8i));
let _e1525 = select(_e1350, _e1520, (_e1520 < _e1350));
let _e1531 = global_5.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1535 = (_e1520 + 1i);
let _e1537 = select(_e1350, _e1535, (_e1535 < _e1350));
let _e1543 = global_5.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1550 = ((_e1531 >> bitcast<u32>((_e1523 & 31u))) | ((_e1543 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1523) & 31u))));
let _e1553 = f32(bitcast<i32>((_e1550 & 65535u)));
let _e1560 = (_e1553 + ((f32(bitcast<i32>((_e1550 >> bitcast<u32>(16i)))) - _e1553) * _e1425));
let _e1562 = (2i * (_e1517 + _e1384));
let _e1564 = (_e1562 >> bitcast<u32>(2i));
let _e1567 = bitcast<u32>(((_e1562 & 3i) * 8i));
let _e1569 = select(_e1350, _e1564, (_e1564 < _e1350));
let _e1575 = global_5.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1579 = (_e1564 + 1i);
let _e1581 = select(_e1350, _e1579, (_e1579 < _e1350));
let _e1587 = global_5.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1594 = ((_e1575 >> bitcast<u32>((_e1567 & 31u))) | ((_e1587 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1567) & 31u))));
let _e1597 = f32(bitcast<i32>((_e1594 & 65535u)));
let _e1607 = (_e1472 + (((_e1509 + ((f32(bitcast<i32>((_e1506 >> bitcast<u32>(16i)))) - _e1509) * _e1425)) - _e1472) * _e1427));
phi_2379_ = (_e1607 + (((_e1560 + (((_e1597 + ((f32(bitcast<i32>((_e1594 >> bitcast<u32>(16i)))) - _e1597) * _e1425)) - _e1560) * _e1427)) - _e1607) * (_e1295 - f32(_e1346))));
} else {
phi_2379_ = 0f;
}
let _e1615 = phi_2379_;
phi_1941_ = (_e1274 - 1i);
phi_1944_ = select(_e1276, _e1274, (_e1615 > 32767.5f));
} else {
phi_1941_ = i32();
phi_1944_ = i32();
}
let _e1620 = phi_1941_;
let _e1622 = phi_1944_;
continue;
continuing {
phi_1940_ = _e1620;
phi_1943_ = _e1622;
break if !(_e1277);
}
}
let _e1625 = local_3;
let _e1626 = (_e1625 == _e1049.member_7);
if _e1626 {
phi_7440_ = _e1049;
phi_7441_ = _e1626;
} else {
phi_2391_ = 0i;
phi_2394_ = 0f;
phi_2396_ = _e1260;
loop {
let _e1628 = phi_2391_;
let _e1630 = phi_2394_;
let _e1632 = phi_2396_;
local_5 = _e1632;
local_6 = _e1632;
local_7 = _e1632;
local_10 = _e1632;
local_12 = _e1632;
local_13 = _e1632;
local_14 = _e1632;
local_15 = _e1632;
local_16 = _e1632;
let _e1633 = (_e1628 < 12i);
if _e1633 {
let _e1635 = (0.5f * (_e1630 + _e1632));
phi_2425_ = _e1272;
phi_2428_ = 16i;
loop {
let _e1643 = phi_2425_;
let _e1645 = phi_2428_;
local_4 = _e1645;
let _e1646 = (_e1643 >= 0i);
if _e1646 {
let _e1650 = global_1.member.member_2.member;
let _e1655 = global_1.member.member_2.member_1;
let _e1660 = global_1.member.member_2.member_2;
let _e1662 = ((_e1049.member.x + (_e1049.member_1.x * _e1635)) - 0.5f);
let _e1663 = ((_e1049.member.y + (_e1049.member_1.y * _e1635)) - 0.5f);
let _e1664 = ((_e1049.member.z + (_e1049.member_1.z * _e1635)) - 0.5f);
let _e1666 = f32((bitcast<i32>(_e1650) - 2i));
let _e1668 = select(0f, _e1662, (_e1662 > 0f));
let _e1670 = select(_e1666, _e1668, (_e1668 < _e1666));
let _e1677 = select(0i, select(select(i32(_e1670), i32(-2147483648), (_e1670 < -2147483600f)), 2147483647i, (_e1670 > 2147483500f)), (_e1670 == _e1670));
let _e1681 = (_e1677 - select(0i, 1i, (_e1670 < f32(_e1677))));
let _e1683 = f32((bitcast<i32>(_e1655) - 2i));
let _e1685 = select(0f, _e1663, (_e1663 > 0f));
let _e1687 = select(_e1683, _e1685, (_e1685 < _e1683));
let _e1694 = select(0i, select(select(i32(_e1687), i32(-2147483648), (_e1687 < -2147483600f)), 2147483647i, (_e1687 > 2147483500f)), (_e1687 == _e1687));
let _e1698 = (_e1694 - select(0i, 1i, (_e1687 < f32(_e1694))));
let _e1700 = f32((bitcast<i32>(_e1660) - 2i));
let _e1702 = select(0f, _e1664, (_e1664 > 0f));
let _e1704 = select(_e1700, _e1702, (_e1702 < _e1700));
let _e1711 = select(0i, select(select(i32(_e1704), i32(-2147483648), (_e1704 < -2147483600f)), 2147483647i, (_e1704 > 2147483500f)), (_e1704 == _e1704));
let _e1715 = (_e1711 - select(0i, 1i, (_e1704 < f32(_e1711))));
let _e1716 = (_e1643 * 4i);
let _e1717 = (_e1716 + 1i);
let _e1719 = (bitcast<i32>(_e110) - 1i);
let _e1721 = select(_e1719, _e1717, (_e1717 < _e1719));
let _e1727 = global_5.member[bitcast<u32>(select(0i, _e1721, (_e1721 > 0i)))];
let _e1728 = (_e1716 + 2i);
let _e1730 = select(_e1719, _e1728, (_e1728 < _e1719));
let _e1736 = global_5.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1737 = (_e1716 + 3i);
let _e1739 = select(_e1719, _e1737, (_e1737 < _e1719));
let _e1745 = global_5.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1748 = (_e1681 - bitcast<i32>((_e1727 & 65535u)));
let _e1753 = bitcast<i32>((_e1727 >> bitcast<u32>(16i)));
let _e1758 = (_e1698 - bitcast<i32>((_e1736 & 65535u)));
let _e1763 = bitcast<i32>((_e1736 >> bitcast<u32>(16i)));
let _e1768 = (_e1715 - bitcast<i32>((_e1745 & 65535u)));
if ((((_e1748 >= 0i) && ((_e1748 + 1i) < _e1753)) && ((_e1758 >= 0i) && ((_e1758 + 1i) < _e1763))) && ((_e1768 >= 0i) && ((_e1768 + 1i) < bitcast<i32>((_e1745 >> bitcast<u32>(16i)))))) {
let _e1778 = (_e1763 * _e1753);
let _e1780 = select(_e1719, _e1716, (_e1716 < _e1719));
let _e1786 = global_5.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1792 = (((bitcast<i32>(_e1786) + (_e1768 * _e1778)) + (_e1758 * _e1753)) + _e1748);
let _e1794 = (_e1662 - f32(_e1681));
let _e1796 = (_e1663 - f32(_e1698));
let _e1799 = (2i * _e1792);
let _e1801 = (_e1799 >> bitcast<u32>(2i));
let _e1804 = bitcast<u32>(((_e1799 & 3i) * 8i));
let _e1806 = select(_e1719, _e1801, (_e1801 < _e1719));
let _e1812 = global_5.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1816 = (_e1801 + 1i);
let _e1818 = select(_e1719, _e1816, (_e1816 < _e1719));
let _e1824 = global_5.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1831 = ((_e1812 >> bitcast<u32>((_e1804 & 31u))) | ((_e1824 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1804) & 31u))));
let _e1834 = f32(bitcast<i32>((_e1831 & 65535u)));
let _e1841 = (_e1834 + ((f32(bitcast<i32>((_e1831 >> bitcast<u32>(16i)))) - _e1834) * _e1794));
let _e1843 = (2i * (_e1792 + _e1753));
let _e1845 = (_e1843 >> bitcast<u32>(2i));
let _e1848 = bitcast<u32>(((_e1843 & 3i) * 8i));
let _e1850 = select(_e1719, _e1845, (_e1845 < _e1719));
let _e1856 = global_5.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1860 = (_e1845 + 1i);
let _e1862 = select(_e1719, _e1860, (_e1860 < _e1719));
let _e1868 = global_5.member[bitcast<u32>(select(0i, _e1862, (_e1862 > 0i)))];
let _e1875 = ((_e1856 >> bitcast<u32>((_e1848 & 31u))) | ((_e1868 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1848) & 31u))));
let _e1878 = f32(bitcast<i32>((_e1875 & 65535u)));
let _e1886 = (_e1792 + _e1778);
let _e1887 = (2i * _e1886);
let _e1889 = (_e1887 >> bitcast<u32>(2i));
let _e1892 = bitcast<u32>(((_e1887 & 3i) * 8i));
let _e1894 = select(_e1719, _e1889, (_e1889 < _e1719));
let _e1900 = global_5.member[bitcast<u32>(select(0i, _e1894, (_e1894 > 0i)))];
let _e1904 = (_e1889 + 1i);
let _e1906 = select(_e1719, _e1904, (_e1904 < _e1719));
let _e1912 = global_5.member[bitcast<u32>(select(0i, _e1906, (_e1906 > 0i)))];
let _e1919 = ((_e1900 >> bitcast<u32>((_e1892 & 31u))) | ((_e1912 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1892) & 31u))));
let _e1922 = f32(bitcast<i32>((_e1919 & 65535u)));
let _e1929 = (_e1922 + ((f32(bitcast<i32>((_e1919 >> bitcast<u32>(16i)))) - _e1922) * _e1794));
let _e1931 = (2i * (_e1886 + _e1753));
let _e1933 = (_e1931 >> bitcast<u32>(2i));
let _e1936 = bitcast<u32>(((_e1931 & 3i) * 8i));
let _e1938 = select(_e1719, _e1933, (_e1933 < _e1719));
let _e1944 = global_5.member[bitcast<u32>(select(0i, _e1938, (_e1938 > 0i)))];
let _e1948 = (_e1933 + 1i);
let _e1950 = select(_e1719, _e1948, (_e1948 < _e1719));
let _e1956 = global_5.member[bitcast<u32>(select(0i, _e1950, (_e1950 > 0i)))];
let _e1963 = ((_e1944 >> bitcast<u32>((_e1936 & 31u))) | ((_e1956 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1936) & 31u))));
let _e1966 = f32(bitcast<i32>((_e1963 & 65535u)));
let _e1976 = (_e1841 + (((_e1878 + ((f32(bitcast<i32>((_e1875 >> bitcast<u32>(16i)))) - _e1878) * _e1794)) - _e1841) * _e1796));
phi_2864_ = (_e1976 + (((_e1929 + (((_e1966 + ((f32(bitcast<i32>((_e1963 >> bitcast<u32>(16i)))) - _e1966) * _e1794)) - _e1929) * _e1796)) - _e1976) * (_e1664 - f32(_e1715))));
} else {
phi_2864_ = 0f;
}
let _e1984 = phi_2864_;
phi_2426_ = (_e1643 - 1i);
phi_2429_ = select(_e1645, _e1643, (_e1984 > 32767.5f));
} else {
phi_2426_ = i32();
phi_2429_ = i32();
}
let _e1989 = phi_2426_;
let _e1991 = phi_2429_;
continue;
continuing {
phi_2425_ = _e1989;
phi_2428_ = _e1991;
break if !(_e1646);
}
}
let _e1994 = local_4;
let _e1995 = (_e1994 == _e1049.member_7);
phi_2392_ = (_e1628 + 1i);
phi_2395_ = select(_e1630, _e1635, _e1995);
phi_2397_ = select(_e1635, _e1632, _e1995);
} else {
phi_2392_ = i32();
phi_2395_ = f32();
phi_2397_ = f32();
}
let _e2000 = phi_2392_;
let _e2002 = phi_2395_;
let _e2004 = phi_2397_;
continue;
continuing {
phi_2391_ = _e2000;
phi_2394_ = _e2002;
phi_2396_ = _e2004;
break if !(_e1633);
}
}
let _e2007 = local_5;
let _e2008 = (_e1049.member_1.x * _e2007);
let _e2010 = local_6;
let _e2011 = (_e1049.member_1.y * _e2010);
let _e2013 = local_7;
let _e2014 = (_e1049.member_1.z * _e2013);
phi_2899_ = _e1272;
phi_2902_ = 16i;
loop {
let _e2021 = phi_2899_;
let _e2023 = phi_2902_;
local_8 = _e2023;
local_9 = _e2023;
local_11 = _e2023;
local_17 = _e2023;
local_18 = _e2023;
local_19 = _e2023;
local_20 = _e2023;
let _e2024 = (_e2021 >= 0i);
if _e2024 {
let _e2028 = global_1.member.member_2.member;
let _e2033 = global_1.member.member_2.member_1;
let _e2038 = global_1.member.member_2.member_2;
let _e2040 = ((_e1049.member.x + _e2008) - 0.5f);
let _e2041 = ((_e1049.member.y + _e2011) - 0.5f);
let _e2042 = ((_e1049.member.z + _e2014) - 0.5f);
let _e2044 = f32((bitcast<i32>(_e2028) - 2i));
let _e2046 = select(0f, _e2040, (_e2040 > 0f));
let _e2048 = select(_e2044, _e2046, (_e2046 < _e2044));
let _e2055 = select(0i, select(select(i32(_e2048), i32(-2147483648), (_e2048 < -2147483600f)), 2147483647i, (_e2048 > 2147483500f)), (_e2048 == _e2048));
let _e2059 = (_e2055 - select(0i, 1i, (_e2048 < f32(_e2055))));
let _e2061 = f32((bitcast<i32>(_e2033) - 2i));
let _e2063 = select(0f, _e2041, (_e2041 > 0f));
let _e2065 = select(_e2061, _e2063, (_e2063 < _e2061));
let _e2072 = select(0i, select(select(i32(_e2065), i32(-2147483648), (_e2065 < -2147483600f)), 2147483647i, (_e2065 > 2147483500f)), (_e2065 == _e2065));
let _e2076 = (_e2072 - select(0i, 1i, (_e2065 < f32(_e2072))));
let _e2078 = f32((bitcast<i32>(_e2038) - 2i));
let _e2080 = select(0f, _e2042, (_e2042 > 0f));
let _e2082 = select(_e2078, _e2080, (_e2080 < _e2078));
let _e2089 = select(0i, select(select(i32(_e2082), i32(-2147483648), (_e2082 < -2147483600f)), 2147483647i, (_e2082 > 2147483500f)), (_e2082 == _e2082));
let _e2093 = (_e2089 - select(0i, 1i, (_e2082 < f32(_e2089))));
let _e2094 = (_e2021 * 4i);
let _e2095 = (_e2094 + 1i);
let _e2097 = (bitcast<i32>(_e110) - 1i);
let _e2099 = select(_e2097, _e2095, (_e2095 < _e2097));
let _e2105 = global_5.member[bitcast<u32>(select(0i, _e2099, (_e2099 > 0i)))];
let _e2106 = (_e2094 + 2i);
let _e2108 = select(_e2097, _e2106, (_e2106 < _e2097));
let _e2114 = global_5.member[bitcast<u32>(select(0i, _e2108, (_e2108 > 0i)))];
let _e2115 = (_e2094 + 3i);
let _e2117 = select(_e2097, _e2115, (_e2115 < _e2097));
let _e2123 = global_5.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2126 = (_e2059 - bitcast<i32>((_e2105 & 65535u)));
let _e2131 = bitcast<i32>((_e2105 >> bitcast<u32>(16i)));
let _e2136 = (_e2076 - bitcast<i32>((_e2114 & 65535u)));
let _e2141 = bitcast<i32>((_e2114 >> bitcast<u32>(16i)));
let _e2146 = (_e2093 - bitcast<i32>((_e2123 & 65535u)));
if ((((_e2126 >= 0i) && ((_e2126 + 1i) < _e2131)) && ((_e2136 >= 0i) && ((_e2136 + 1i) < _e2141))) && ((_e2146 >= 0i) && ((_e2146 + 1i) < bitcast<i32>((_e2123 >> bitcast<u32>(16i)))))) {
let _e2156 = (_e2141 * _e2131);
let _e2158 = select(_e2097, _e2094, (_e2094 < _e2097));
let _e2164 = global_5.member[bitcast<u32>(select(0i, _e2158, (_e2158 > 0i)))];
let _e2170 = (((bitcast<i32>(_e2164) + (_e2146 * _e2156)) + (_e2136 * _e2131)) + _e2126);
let _e2172 = (_e2040 - f32(_e2059));
let _e2174 = (_e2041 - f32(_e2076));
let _e2177 = (2i * _e2170);
let _e2179 = (_e2177 >> bitcast<u32>(2i));
let _e2182 = bitcast<u32>(((_e2177 & 3i) * 8i));
let _e2184 = select(_e2097, _e2179, (_e2179 < _e2097));
let _e2190 = global_5.member[bitcast<u32>(select(0i, _e2184, (_e2184 > 0i)))];
let _e2194 = (_e2179 + 1i);
let _e2196 = select(_e2097, _e2194, (_e2194 < _e2097));
let _e2202 = global_5.member[bitcast<u32>(select(0i, _e2196, (_e2196 > 0i)))];
let _e2209 = ((_e2190 >> bitcast<u32>((_e2182 & 31u))) | ((_e2202 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2182) & 31u))));
let _e2212 = f32(bitcast<i32>((_e2209 & 65535u)));
let _e2219 = (_e2212 + ((f32(bitcast<i32>((_e2209 >> bitcast<u32>(16i)))) - _e2212) * _e2172));
let _e2221 = (2i * (_e2170 + _e2131));
let _e2223 = (_e2221 >> bitcast<u32>(2i));
let _e2226 = bitcast<u32>(((_e2221 & 3i) * 8i));
let _e2228 = select(_e2097, _e2223, (_e2223 < _e2097));
let _e2234 = global_5.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2238 = (_e2223 + 1i);
let _e2240 = select(_e2097, _e2238, (_e2238 < _e2097));
let _e2246 = global_5.member[bitcast<u32>(select(0i, _e2240, (_e2240 > 0i)))];
let _e2253 = ((_e2234 >> bitcast<u32>((_e2226 & 31u))) | ((_e2246 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2226) & 31u))));
let _e2256 = f32(bitcast<i32>((_e2253 & 65535u)));
let _e2264 = (_e2170 + _e2156);
let _e2265 = (2i * _e2264);
let _e2267 = (_e2265 >> bitcast<u32>(2i));
let _e2270 = bitcast<u32>(((_e2265 & 3i) * 8i));
let _e2272 = select(_e2097, _e2267, (_e2267 < _e2097));
let _e2278 = global_5.member[bitcast<u32>(select(0i, _e2272, (_e2272 > 0i)))];
let _e2282 = (_e2267 + 1i);
let _e2284 = select(_e2097, _e2282, (_e2282 < _e2097));
let _e2290 = global_5.member[bitcast<u32>(select(0i, _e2284, (_e2284 > 0i)))];
let _e2297 = ((_e2278 >> bitcast<u32>((_e2270 & 31u))) | ((_e2290 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2270) & 31u))));
let _e2300 = f32(bitcast<i32>((_e2297 & 65535u)));
let _e2307 = (_e2300 + ((f32(bitcast<i32>((_e2297 >> bitcast<u32>(16i)))) - _e2300) * _e2172));
let _e2309 = (2i * (_e2264 + _e2131));
let _e2311 = (_e2309 >> bitcast<u32>(2i));
let _e2314 = bitcast<u32>(((_e2309 & 3i) * 8i));
let _e2316 = select(_e2097, _e2311, (_e2311 < _e2097));
let _e2322 = global_5.member[bitcast<u32>(select(0i, _e2316, (_e2316 > 0i)))];
let _e2326 = (_e2311 + 1i);
let _e2328 = select(_e2097, _e2326, (_e2326 < _e2097));
let _e2334 = global_5.member[bitcast<u32>(select(0i, _e2328, (_e2328 > 0i)))];
let _e2341 = ((_e2322 >> bitcast<u32>((_e2314 & 31u))) | ((_e2334 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2314) & 31u))));
let _e2344 = f32(bitcast<i32>((_e2341 & 65535u)));
let _e2354 = (_e2219 + (((_e2256 + ((f32(bitcast<i32>((_e2253 >> bitcast<u32>(16i)))) - _e2256) * _e2172)) - _e2219) * _e2174));
phi_3338_ = (_e2354 + (((_e2307 + (((_e2344 + ((f32(bitcast<i32>((_e2341 >> bitcast<u32>(16i)))) - _e2344) * _e2172)) - _e2307) * _e2174)) - _e2354) * (_e2042 - f32(_e2093))));
} else {
phi_3338_ = 0f;
}
let _e2362 = phi_3338_;
phi_2900_ = (_e2021 - 1i);
phi_2903_ = select(_e2023, _e2021, (_e2362 > 32767.5f));
} else {
phi_2900_ = i32();
phi_2903_ = i32();
}
let _e2367 = phi_2900_;
let _e2369 = phi_2903_;
continue;
continuing {
phi_2899_ = _e2367;
phi_2902_ = _e2369;
break if !(_e2024);
}
}
let _e2372 = local_8;
let _e2375 = local_9;
local = select(_e1049.member_7, _e2375, (_e2372 < _e1049.member_7));
local_1 = (_e1049.member + vec3<f32>(_e2008, _e2011, _e2014));
let _e2380 = local;
let _e2381 = local_1[0u];
let _e2383 = local_1[1u];
let _e2385 = local_1[2u];
let _e2389 = global_1.member.member_2.member;
let _e2393 = global_1.member.member_2.member_1;
let _e2397 = global_1.member.member_2.member_2;
let _e2399 = ((_e2381 + -1f) - 0.5f);
let _e2400 = ((_e2383 + 0f) - 0.5f);
let _e2401 = ((_e2385 + 0f) - 0.5f);
let _e2403 = f32((bitcast<i32>(_e2389) - 2i));
let _e2405 = select(0f, _e2399, (_e2399 > 0f));
let _e2407 = select(_e2403, _e2405, (_e2405 < _e2403));
let _e2414 = select(0i, select(select(i32(_e2407), i32(-2147483648), (_e2407 < -2147483600f)), 2147483647i, (_e2407 > 2147483500f)), (_e2407 == _e2407));
let _e2418 = (_e2414 - select(0i, 1i, (_e2407 < f32(_e2414))));
let _e2420 = f32((bitcast<i32>(_e2393) - 2i));
let _e2422 = select(0f, _e2400, (_e2400 > 0f));
let _e2424 = select(_e2420, _e2422, (_e2422 < _e2420));
let _e2431 = select(0i, select(select(i32(_e2424), i32(-2147483648), (_e2424 < -2147483600f)), 2147483647i, (_e2424 > 2147483500f)), (_e2424 == _e2424));
let _e2435 = (_e2431 - select(0i, 1i, (_e2424 < f32(_e2431))));
let _e2437 = f32((bitcast<i32>(_e2397) - 2i));
let _e2439 = select(0f, _e2401, (_e2401 > 0f));
let _e2441 = select(_e2437, _e2439, (_e2439 < _e2437));
let _e2448 = select(0i, select(select(i32(_e2441), i32(-2147483648), (_e2441 < -2147483600f)), 2147483647i, (_e2441 > 2147483500f)), (_e2441 == _e2441));
let _e2452 = (_e2448 - select(0i, 1i, (_e2441 < f32(_e2448))));
let _e2453 = (_e2380 * 4i);
let _e2454 = (_e2453 + 1i);
let _e2456 = (bitcast<i32>(_e110) - 1i);
let _e2458 = select(_e2456, _e2454, (_e2454 < _e2456));
let _e2463 = global_5.member[bitcast<u32>(select(0i, _e2458, (_e2458 > 0i)))];
let _e2464 = (_e2453 + 2i);
let _e2466 = select(_e2456, _e2464, (_e2464 < _e2456));
let _e2471 = global_5.member[bitcast<u32>(select(0i, _e2466, (_e2466 > 0i)))];
let _e2472 = (_e2453 + 3i);
let _e2474 = select(_e2456, _e2472, (_e2472 < _e2456));
let _e2479 = global_5.member[bitcast<u32>(select(0i, _e2474, (_e2474 > 0i)))];
let _e2482 = (_e2418 - bitcast<i32>((_e2463 & 65535u)));
let _e2487 = bitcast<i32>((_e2463 >> bitcast<u32>(16i)));
let _e2492 = (_e2435 - bitcast<i32>((_e2471 & 65535u)));
let _e2497 = bitcast<i32>((_e2471 >> bitcast<u32>(16i)));
let _e2502 = (_e2452 - bitcast<i32>((_e2479 & 65535u)));
if ((((_e2482 >= 0i) && ((_e2482 + 1i) < _e2487)) && ((_e2492 >= 0i) && ((_e2492 + 1i) < _e2497))) && ((_e2502 >= 0i) && ((_e2502 + 1i) < bitcast<i32>((_e2479 >> bitcast<u32>(16i)))))) {
let _e2512 = (_e2497 * _e2487);
let _e2514 = select(_e2456, _e2453, (_e2453 < _e2456));
let _e2519 = global_5.member[bitcast<u32>(select(0i, _e2514, (_e2514 > 0i)))];
let _e2525 = (((bitcast<i32>(_e2519) + (_e2502 * _e2512)) + (_e2492 * _e2487)) + _e2482);
let _e2527 = (_e2399 - f32(_e2418));
let _e2529 = (_e2400 - f32(_e2435));
let _e2532 = (2i * _e2525);
let _e2534 = (_e2532 >> bitcast<u32>(2i));
let _e2537 = bitcast<u32>(((_e2532 & 3i) * 8i));
let _e2539 = select(_e2456, _e2534, (_e2534 < _e2456));
let _e2544 = global_5.member[bitcast<u32>(select(0i, _e2539, (_e2539 > 0i)))];
let _e2548 = (_e2534 + 1i);
let _e2550 = select(_e2456, _e2548, (_e2548 < _e2456));
let _e2555 = global_5.member[bitcast<u32>(select(0i, _e2550, (_e2550 > 0i)))];
let _e2562 = ((_e2544 >> bitcast<u32>((_e2537 & 31u))) | ((_e2555 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2537) & 31u))));
let _e2565 = f32(bitcast<i32>((_e2562 & 65535u)));
let _e2572 = (_e2565 + ((f32(bitcast<i32>((_e2562 >> bitcast<u32>(16i)))) - _e2565) * _e2527));
let _e2574 = (2i * (_e2525 + _e2487));
let _e2576 = (_e2574 >> bitcast<u32>(2i));
let _e2579 = bitcast<u32>(((_e2574 & 3i) * 8i));
let _e2581 = select(_e2456, _e2576, (_e2576 < _e2456));
let _e2586 = global_5.member[bitcast<u32>(select(0i, _e2581, (_e2581 > 0i)))];
let _e2590 = (_e2576 + 1i);
let _e2592 = select(_e2456, _e2590, (_e2590 < _e2456));
let _e2597 = global_5.member[bitcast<u32>(select(0i, _e2592, (_e2592 > 0i)))];
let _e2604 = ((_e2586 >> bitcast<u32>((_e2579 & 31u))) | ((_e2597 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2579) & 31u))));
let _e2607 = f32(bitcast<i32>((_e2604 & 65535u)));
let _e2615 = (_e2525 + _e2512);
let _e2616 = (2i * _e2615);
let _e2618 = (_e2616 >> bitcast<u32>(2i));
let _e2621 = bitcast<u32>(((_e2616 & 3i) * 8i));
let _e2623 = select(_e2456, _e2618, (_e2618 < _e2456));
let _e2628 = global_5.member[bitcast<u32>(select(0i, _e2623, (_e2623 > 0i)))];
let _e2632 = (_e2618 + 1i);
let _e2634 = select(_e2456, _e2632, (_e2632 < _e2456));
let _e2639 = global_5.member[bitcast<u32>(select(0i, _e2634, (_e2634 > 0i)))];
let _e2646 = ((_e2628 >> bitcast<u32>((_e2621 & 31u))) | ((_e2639 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2621) & 31u))));
let _e2649 = f32(bitcast<i32>((_e2646 & 65535u)));
let _e2656 = (_e2649 + ((f32(bitcast<i32>((_e2646 >> bitcast<u32>(16i)))) - _e2649) * _e2527));
let _e2658 = (2i * (_e2615 + _e2487));
let _e2660 = (_e2658 >> bitcast<u32>(2i));
let _e2663 = bitcast<u32>(((_e2658 & 3i) * 8i));
let _e2665 = select(_e2456, _e2660, (_e2660 < _e2456));
let _e2670 = global_5.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2674 = (_e2660 + 1i);
let _e2676 = select(_e2456, _e2674, (_e2674 < _e2456));
let _e2681 = global_5.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2688 = ((_e2670 >> bitcast<u32>((_e2663 & 31u))) | ((_e2681 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2663) & 31u))));
let _e2691 = f32(bitcast<i32>((_e2688 & 65535u)));
let _e2701 = (_e2572 + (((_e2607 + ((f32(bitcast<i32>((_e2604 >> bitcast<u32>(16i)))) - _e2607) * _e2527)) - _e2572) * _e2529));
phi_3798_ = (_e2701 + (((_e2656 + (((_e2691 + ((f32(bitcast<i32>((_e2688 >> bitcast<u32>(16i)))) - _e2691) * _e2527)) - _e2656) * _e2529)) - _e2701) * (_e2401 - f32(_e2452))));
} else {
phi_3798_ = 0f;
}
let _e2709 = phi_3798_;
let _e2710 = local;
let _e2711 = local_1[0u];
let _e2713 = local_1[1u];
let _e2715 = local_1[2u];
let _e2717 = ((_e2711 + 1f) - 0.5f);
let _e2718 = ((_e2713 + 0f) - 0.5f);
let _e2719 = ((_e2715 + 0f) - 0.5f);
let _e2721 = select(0f, _e2717, (_e2717 > 0f));
let _e2723 = select(_e2403, _e2721, (_e2721 < _e2403));
let _e2730 = select(0i, select(select(i32(_e2723), i32(-2147483648), (_e2723 < -2147483600f)), 2147483647i, (_e2723 > 2147483500f)), (_e2723 == _e2723));
let _e2734 = (_e2730 - select(0i, 1i, (_e2723 < f32(_e2730))));
let _e2736 = select(0f, _e2718, (_e2718 > 0f));
let _e2738 = select(_e2420, _e2736, (_e2736 < _e2420));
let _e2745 = select(0i, select(select(i32(_e2738), i32(-2147483648), (_e2738 < -2147483600f)), 2147483647i, (_e2738 > 2147483500f)), (_e2738 == _e2738));
let _e2749 = (_e2745 - select(0i, 1i, (_e2738 < f32(_e2745))));
let _e2751 = select(0f, _e2719, (_e2719 > 0f));
let _e2753 = select(_e2437, _e2751, (_e2751 < _e2437));
let _e2760 = select(0i, select(select(i32(_e2753), i32(-2147483648), (_e2753 < -2147483600f)), 2147483647i, (_e2753 > 2147483500f)), (_e2753 == _e2753));
let _e2764 = (_e2760 - select(0i, 1i, (_e2753 < f32(_e2760))));
let _e2765 = (_e2710 * 4i);
let _e2766 = (_e2765 + 1i);
let _e2768 = select(_e2456, _e2766, (_e2766 < _e2456));
let _e2773 = global_5.member[bitcast<u32>(select(0i, _e2768, (_e2768 > 0i)))];
let _e2774 = (_e2765 + 2i);
let _e2776 = select(_e2456, _e2774, (_e2774 < _e2456));
let _e2781 = global_5.member[bitcast<u32>(select(0i, _e2776, (_e2776 > 0i)))];
let _e2782 = (_e2765 + 3i);
let _e2784 = select(_e2456, _e2782, (_e2782 < _e2456));
let _e2789 = global_5.member[bitcast<u32>(select(0i, _e2784, (_e2784 > 0i)))];
let _e2792 = (_e2734 - bitcast<i32>((_e2773 & 65535u)));
let _e2797 = bitcast<i32>((_e2773 >> bitcast<u32>(16i)));
let _e2802 = (_e2749 - bitcast<i32>((_e2781 & 65535u)));
let _e2807 = bitcast<i32>((_e2781 >> bitcast<u32>(16i)));
let _e2812 = (_e2764 - bitcast<i32>((_e2789 & 65535u)));
if ((((_e2792 >= 0i) && ((_e2792 + 1i) < _e2797)) && ((_e2802 >= 0i) && ((_e2802 + 1i) < _e2807))) && ((_e2812 >= 0i) && ((_e2812 + 1i) < bitcast<i32>((_e2789 >> bitcast<u32>(16i)))))) {
let _e2822 = (_e2807 * _e2797);
let _e2824 = select(_e2456, _e2765, (_e2765 < _e2456));
let _e2829 = global_5.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2835 = (((bitcast<i32>(_e2829) + (_e2812 * _e2822)) + (_e2802 * _e2797)) + _e2792);
let _e2837 = (_e2717 - f32(_e2734));
let _e2839 = (_e2718 - f32(_e2749));
let _e2842 = (2i * _e2835);
let _e2844 = (_e2842 >> bitcast<u32>(2i));
let _e2847 = bitcast<u32>(((_e2842 & 3i) * 8i));
let _e2849 = select(_e2456, _e2844, (_e2844 < _e2456));
let _e2854 = global_5.member[bitcast<u32>(select(0i, _e2849, (_e2849 > 0i)))];
let _e2858 = (_e2844 + 1i);
let _e2860 = select(_e2456, _e2858, (_e2858 < _e2456));
let _e2865 = global_5.member[bitcast<u32>(select(0i, _e2860, (_e2860 > 0i)))];
let _e2872 = ((_e2854 >> bitcast<u32>((_e2847 & 31u))) | ((_e2865 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2847) & 31u))));
let _e2875 = f32(bitcast<i32>((_e2872 & 65535u)));
let _e2882 = (_e2875 + ((f32(bitcast<i32>((_e2872 >> bitcast<u32>(16i)))) - _e2875) * _e2837));
let _e2884 = (2i * (_e2835 + _e2797));
let _e2886 = (_e2884 >> bitcast<u32>(2i));
let _e2889 = bitcast<u32>(((_e2884 & 3i) * 8i));
let _e2891 = select(_e2456, _e2886, (_e2886 < _e2456));
let _e2896 = global_5.member[bitcast<u32>(select(0i, _e2891, (_e2891 > 0i)))];
let _e2900 = (_e2886 + 1i);
let _e2902 = select(_e2456, _e2900, (_e2900 < _e2456));
let _e2907 = global_5.member[bitcast<u32>(select(0i, _e2902, (_e2902 > 0i)))];
let _e2914 = ((_e2896 >> bitcast<u32>((_e2889 & 31u))) | ((_e2907 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2889) & 31u))));
let _e2917 = f32(bitcast<i32>((_e2914 & 65535u)));
let _e2925 = (_e2835 + _e2822);
let _e2926 = (2i * _e2925);
let _e2928 = (_e2926 >> bitcast<u32>(2i));
let _e2931 = bitcast<u32>(((_e2926 & 3i) * 8i));
let _e2933 = select(_e2456, _e2928, (_e2928 < _e2456));
let _e2938 = global_5.member[bitcast<u32>(select(0i, _e2933, (_e2933 > 0i)))];
let _e2942 = (_e2928 + 1i);
let _e2944 = select(_e2456, _e2942, (_e2942 < _e2456));
let _e2949 = global_5.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2956 = ((_e2938 >> bitcast<u32>((_e2931 & 31u))) | ((_e2949 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2931) & 31u))));
let _e2959 = f32(bitcast<i32>((_e2956 & 65535u)));
let _e2966 = (_e2959 + ((f32(bitcast<i32>((_e2956 >> bitcast<u32>(16i)))) - _e2959) * _e2837));
let _e2968 = (2i * (_e2925 + _e2797));
let _e2970 = (_e2968 >> bitcast<u32>(2i));
let _e2973 = bitcast<u32>(((_e2968 & 3i) * 8i));
let _e2975 = select(_e2456, _e2970, (_e2970 < _e2456));
let _e2980 = global_5.member[bitcast<u32>(select(0i, _e2975, (_e2975 > 0i)))];
let _e2984 = (_e2970 + 1i);
let _e2986 = select(_e2456, _e2984, (_e2984 < _e2456));
let _e2991 = global_5.member[bitcast<u32>(select(0i, _e2986, (_e2986 > 0i)))];
let _e2998 = ((_e2980 >> bitcast<u32>((_e2973 & 31u))) | ((_e2991 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2973) & 31u))));
let _e3001 = f32(bitcast<i32>((_e2998 & 65535u)));
let _e3011 = (_e2882 + (((_e2917 + ((f32(bitcast<i32>((_e2914 >> bitcast<u32>(16i)))) - _e2917) * _e2837)) - _e2882) * _e2839));
phi_4237_ = (_e3011 + (((_e2966 + (((_e3001 + ((f32(bitcast<i32>((_e2998 >> bitcast<u32>(16i)))) - _e3001) * _e2837)) - _e2966) * _e2839)) - _e3011) * (_e2719 - f32(_e2764))));
} else {
phi_4237_ = 0f;
}
let _e3019 = phi_4237_;
let _e3020 = (_e2709 - _e3019);
let _e3021 = local;
let _e3022 = local_1[0u];
let _e3024 = local_1[1u];
let _e3026 = local_1[2u];
let _e3028 = ((_e3022 + 0f) - 0.5f);
let _e3029 = ((_e3024 + -1f) - 0.5f);
let _e3030 = ((_e3026 + 0f) - 0.5f);
let _e3032 = select(0f, _e3028, (_e3028 > 0f));
let _e3034 = select(_e2403, _e3032, (_e3032 < _e2403));
let _e3041 = select(0i, select(select(i32(_e3034), i32(-2147483648), (_e3034 < -2147483600f)), 2147483647i, (_e3034 > 2147483500f)), (_e3034 == _e3034));
let _e3045 = (_e3041 - select(0i, 1i, (_e3034 < f32(_e3041))));
let _e3047 = select(0f, _e3029, (_e3029 > 0f));
let _e3049 = select(_e2420, _e3047, (_e3047 < _e2420));
let _e3056 = select(0i, select(select(i32(_e3049), i32(-2147483648), (_e3049 < -2147483600f)), 2147483647i, (_e3049 > 2147483500f)), (_e3049 == _e3049));
let _e3060 = (_e3056 - select(0i, 1i, (_e3049 < f32(_e3056))));
let _e3062 = select(0f, _e3030, (_e3030 > 0f));
let _e3064 = select(_e2437, _e3062, (_e3062 < _e2437));
let _e3071 = select(0i, select(select(i32(_e3064), i32(-2147483648), (_e3064 < -2147483600f)), 2147483647i, (_e3064 > 2147483500f)), (_e3064 == _e3064));
let _e3075 = (_e3071 - select(0i, 1i, (_e3064 < f32(_e3071))));
let _e3076 = (_e3021 * 4i);
let _e3077 = (_e3076 + 1i);
let _e3079 = select(_e2456, _e3077, (_e3077 < _e2456));
let _e3084 = global_5.member[bitcast<u32>(select(0i, _e3079, (_e3079 > 0i)))];
let _e3085 = (_e3076 + 2i);
let _e3087 = select(_e2456, _e3085, (_e3085 < _e2456));
let _e3092 = global_5.member[bitcast<u32>(select(0i, _e3087, (_e3087 > 0i)))];
let _e3093 = (_e3076 + 3i);
let _e3095 = select(_e2456, _e3093, (_e3093 < _e2456));
let _e3100 = global_5.member[bitcast<u32>(select(0i, _e3095, (_e3095 > 0i)))];
let _e3103 = (_e3045 - bitcast<i32>((_e3084 & 65535u)));
let _e3108 = bitcast<i32>((_e3084 >> bitcast<u32>(16i)));
let _e3113 = (_e3060 - bitcast<i32>((_e3092 & 65535u)));
let _e3118 = bitcast<i32>((_e3092 >> bitcast<u32>(16i)));
let _e3123 = (_e3075 - bitcast<i32>((_e3100 & 65535u)));
if ((((_e3103 >= 0i) && ((_e3103 + 1i) < _e3108)) && ((_e3113 >= 0i) && ((_e3113 + 1i) < _e3118))) && ((_e3123 >= 0i) && ((_e3123 + 1i) < bitcast<i32>((_e3100 >> bitcast<u32>(16i)))))) {
let _e3133 = (_e3118 * _e3108);
let _e3135 = select(_e2456, _e3076, (_e3076 < _e2456));
let _e3140 = global_5.member[bitcast<u32>(select(0i, _e3135, (_e3135 > 0i)))];
let _e3146 = (((bitcast<i32>(_e3140) + (_e3123 * _e3133)) + (_e3113 * _e3108)) + _e3103);
let _e3148 = (_e3028 - f32(_e3045));
let _e3150 = (_e3029 - f32(_e3060));
let _e3153 = (2i * _e3146);
let _e3155 = (_e3153 >> bitcast<u32>(2i));
let _e3158 = bitcast<u32>(((_e3153 & 3i) * 8i));
let _e3160 = select(_e2456, _e3155, (_e3155 < _e2456));
let _e3165 = global_5.member[bitcast<u32>(select(0i, _e3160, (_e3160 > 0i)))];
let _e3169 = (_e3155 + 1i);
let _e3171 = select(_e2456, _e3169, (_e3169 < _e2456));
let _e3176 = global_5.member[bitcast<u32>(select(0i, _e3171, (_e3171 > 0i)))];
let _e3183 = ((_e3165 >> bitcast<u32>((_e3158 & 31u))) | ((_e3176 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3158) & 31u))));
let _e3186 = f32(bitcast<i32>((_e3183 & 65535u)));
let _e3193 = (_e3186 + ((f32(bitcast<i32>((_e3183 >> bitcast<u32>(16i)))) - _e3186) * _e3148));
let _e3195 = (2i * (_e3146 + _e3108));
let _e3197 = (_e3195 >> bitcast<u32>(2i));
let _e3200 = bitcast<u32>(((_e3195 & 3i) * 8i));
let _e3202 = select(_e2456, _e3197, (_e3197 < _e2456));
let _e3207 = global_5.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3211 = (_e3197 + 1i);
let _e3213 = select(_e2456, _e3211, (_e3211 < _e2456));
let _e3218 = global_5.member[bitcast<u32>(select(0i, _e3213, (_e3213 > 0i)))];
let _e3225 = ((_e3207 >> bitcast<u32>((_e3200 & 31u))) | ((_e3218 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3200) & 31u))));
let _e3228 = f32(bitcast<i32>((_e3225 & 65535u)));
let _e3236 = (_e3146 + _e3133);
let _e3237 = (2i * _e3236);
let _e3239 = (_e3237 >> bitcast<u32>(2i));
let _e3242 = bitcast<u32>(((_e3237 & 3i) * 8i));
let _e3244 = select(_e2456, _e3239, (_e3239 < _e2456));
let _e3249 = global_5.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3253 = (_e3239 + 1i);
let _e3255 = select(_e2456, _e3253, (_e3253 < _e2456));
let _e3260 = global_5.member[bitcast<u32>(select(0i, _e3255, (_e3255 > 0i)))];
let _e3267 = ((_e3249 >> bitcast<u32>((_e3242 & 31u))) | ((_e3260 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3242) & 31u))));
let _e3270 = f32(bitcast<i32>((_e3267 & 65535u)));
let _e3277 = (_e3270 + ((f32(bitcast<i32>((_e3267 >> bitcast<u32>(16i)))) - _e3270) * _e3148));
let _e3279 = (2i * (_e3236 + _e3108));
let _e3281 = (_e3279 >> bitcast<u32>(2i));
let _e3284 = bitcast<u32>(((_e3279 & 3i) * 8i));
let _e3286 = select(_e2456, _e3281, (_e3281 < _e2456));
let _e3291 = global_5.member[bitcast<u32>(select(0i, _e3286, (_e3286 > 0i)))];
let _e3295 = (_e3281 + 1i);
let _e3297 = select(_e2456, _e3295, (_e3295 < _e2456));
let _e3302 = global_5.member[bitcast<u32>(select(0i, _e3297, (_e3297 > 0i)))];
let _e3309 = ((_e3291 >> bitcast<u32>((_e3284 & 31u))) | ((_e3302 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3284) & 31u))));
let _e3312 = f32(bitcast<i32>((_e3309 & 65535u)));
let _e3322 = (_e3193 + (((_e3228 + ((f32(bitcast<i32>((_e3225 >> bitcast<u32>(16i)))) - _e3228) * _e3148)) - _e3193) * _e3150));
phi_4677_ = (_e3322 + (((_e3277 + (((_e3312 + ((f32(bitcast<i32>((_e3309 >> bitcast<u32>(16i)))) - _e3312) * _e3148)) - _e3277) * _e3150)) - _e3322) * (_e3030 - f32(_e3075))));
} else {
phi_4677_ = 0f;
}
let _e3330 = phi_4677_;
let _e3331 = local;
let _e3332 = local_1[0u];
let _e3334 = local_1[1u];
let _e3336 = local_1[2u];
let _e3338 = ((_e3332 + 0f) - 0.5f);
let _e3339 = ((_e3334 + 1f) - 0.5f);
let _e3340 = ((_e3336 + 0f) - 0.5f);
let _e3342 = select(0f, _e3338, (_e3338 > 0f));
let _e3344 = select(_e2403, _e3342, (_e3342 < _e2403));
let _e3351 = select(0i, select(select(i32(_e3344), i32(-2147483648), (_e3344 < -2147483600f)), 2147483647i, (_e3344 > 2147483500f)), (_e3344 == _e3344));
let _e3355 = (_e3351 - select(0i, 1i, (_e3344 < f32(_e3351))));
let _e3357 = select(0f, _e3339, (_e3339 > 0f));
let _e3359 = select(_e2420, _e3357, (_e3357 < _e2420));
let _e3366 = select(0i, select(select(i32(_e3359), i32(-2147483648), (_e3359 < -2147483600f)), 2147483647i, (_e3359 > 2147483500f)), (_e3359 == _e3359));
let _e3370 = (_e3366 - select(0i, 1i, (_e3359 < f32(_e3366))));
let _e3372 = select(0f, _e3340, (_e3340 > 0f));
let _e3374 = select(_e2437, _e3372, (_e3372 < _e2437));
let _e3381 = select(0i, select(select(i32(_e3374), i32(-2147483648), (_e3374 < -2147483600f)), 2147483647i, (_e3374 > 2147483500f)), (_e3374 == _e3374));
let _e3385 = (_e3381 - select(0i, 1i, (_e3374 < f32(_e3381))));
let _e3386 = (_e3331 * 4i);
let _e3387 = (_e3386 + 1i);
let _e3389 = select(_e2456, _e3387, (_e3387 < _e2456));
let _e3394 = global_5.member[bitcast<u32>(select(0i, _e3389, (_e3389 > 0i)))];
let _e3395 = (_e3386 + 2i);
let _e3397 = select(_e2456, _e3395, (_e3395 < _e2456));
let _e3402 = global_5.member[bitcast<u32>(select(0i, _e3397, (_e3397 > 0i)))];
let _e3403 = (_e3386 + 3i);
let _e3405 = select(_e2456, _e3403, (_e3403 < _e2456));
let _e3410 = global_5.member[bitcast<u32>(select(0i, _e3405, (_e3405 > 0i)))];
let _e3413 = (_e3355 - bitcast<i32>((_e3394 & 65535u)));
let _e3418 = bitcast<i32>((_e3394 >> bitcast<u32>(16i)));
let _e3423 = (_e3370 - bitcast<i32>((_e3402 & 65535u)));
let _e3428 = bitcast<i32>((_e3402 >> bitcast<u32>(16i)));
let _e3433 = (_e3385 - bitcast<i32>((_e3410 & 65535u)));
if ((((_e3413 >= 0i) && ((_e3413 + 1i) < _e3418)) && ((_e3423 >= 0i) && ((_e3423 + 1i) < _e3428))) && ((_e3433 >= 0i) && ((_e3433 + 1i) < bitcast<i32>((_e3410 >> bitcast<u32>(16i)))))) {
let _e3443 = (_e3428 * _e3418);
let _e3445 = select(_e2456, _e3386, (_e3386 < _e2456));
let _e3450 = global_5.member[bitcast<u32>(select(0i, _e3445, (_e3445 > 0i)))];
let _e3456 = (((bitcast<i32>(_e3450) + (_e3433 * _e3443)) + (_e3423 * _e3418)) + _e3413);
let _e3458 = (_e3338 - f32(_e3355));
let _e3460 = (_e3339 - f32(_e3370));
let _e3463 = (2i * _e3456);
let _e3465 = (_e3463 >> bitcast<u32>(2i));
let _e3468 = bitcast<u32>(((_e3463 & 3i) * 8i));
let _e3470 = select(_e2456, _e3465, (_e3465 < _e2456));
let _e3475 = global_5.member[bitcast<u32>(select(0i, _e3470, (_e3470 > 0i)))];
let _e3479 = (_e3465 + 1i);
let _e3481 = select(_e2456, _e3479, (_e3479 < _e2456));
let _e3486 = global_5.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3493 = ((_e3475 >> bitcast<u32>((_e3468 & 31u))) | ((_e3486 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3468) & 31u))));
let _e3496 = f32(bitcast<i32>((_e3493 & 65535u)));
let _e3503 = (_e3496 + ((f32(bitcast<i32>((_e3493 >> bitcast<u32>(16i)))) - _e3496) * _e3458));
let _e3505 = (2i * (_e3456 + _e3418));
let _e3507 = (_e3505 >> bitcast<u32>(2i));
let _e3510 = bitcast<u32>(((_e3505 & 3i) * 8i));
let _e3512 = select(_e2456, _e3507, (_e3507 < _e2456));
let _e3517 = global_5.member[bitcast<u32>(select(0i, _e3512, (_e3512 > 0i)))];
let _e3521 = (_e3507 + 1i);
let _e3523 = select(_e2456, _e3521, (_e3521 < _e2456));
let _e3528 = global_5.member[bitcast<u32>(select(0i, _e3523, (_e3523 > 0i)))];
let _e3535 = ((_e3517 >> bitcast<u32>((_e3510 & 31u))) | ((_e3528 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3510) & 31u))));
let _e3538 = f32(bitcast<i32>((_e3535 & 65535u)));
let _e3546 = (_e3456 + _e3443);
let _e3547 = (2i * _e3546);
let _e3549 = (_e3547 >> bitcast<u32>(2i));
let _e3552 = bitcast<u32>(((_e3547 & 3i) * 8i));
let _e3554 = select(_e2456, _e3549, (_e3549 < _e2456));
let _e3559 = global_5.member[bitcast<u32>(select(0i, _e3554, (_e3554 > 0i)))];
let _e3563 = (_e3549 + 1i);
let _e3565 = select(_e2456, _e3563, (_e3563 < _e2456));
let _e3570 = global_5.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3577 = ((_e3559 >> bitcast<u32>((_e3552 & 31u))) | ((_e3570 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3552) & 31u))));
let _e3580 = f32(bitcast<i32>((_e3577 & 65535u)));
let _e3587 = (_e3580 + ((f32(bitcast<i32>((_e3577 >> bitcast<u32>(16i)))) - _e3580) * _e3458));
let _e3589 = (2i * (_e3546 + _e3418));
let _e3591 = (_e3589 >> bitcast<u32>(2i));
let _e3594 = bitcast<u32>(((_e3589 & 3i) * 8i));
let _e3596 = select(_e2456, _e3591, (_e3591 < _e2456));
let _e3601 = global_5.member[bitcast<u32>(select(0i, _e3596, (_e3596 > 0i)))];
let _e3605 = (_e3591 + 1i);
let _e3607 = select(_e2456, _e3605, (_e3605 < _e2456));
let _e3612 = global_5.member[bitcast<u32>(select(0i, _e3607, (_e3607 > 0i)))];
let _e3619 = ((_e3601 >> bitcast<u32>((_e3594 & 31u))) | ((_e3612 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3594) & 31u))));
let _e3622 = f32(bitcast<i32>((_e3619 & 65535u)));
let _e3632 = (_e3503 + (((_e3538 + ((f32(bitcast<i32>((_e3535 >> bitcast<u32>(16i)))) - _e3538) * _e3458)) - _e3503) * _e3460));
phi_5116_ = (_e3632 + (((_e3587 + (((_e3622 + ((f32(bitcast<i32>((_e3619 >> bitcast<u32>(16i)))) - _e3622) * _e3458)) - _e3587) * _e3460)) - _e3632) * (_e3340 - f32(_e3385))));
} else {
phi_5116_ = 0f;
}
let _e3640 = phi_5116_;
let _e3641 = (_e3330 - _e3640);
let _e3642 = local;
let _e3643 = local_1[0u];
let _e3645 = local_1[1u];
let _e3647 = local_1[2u];
let _e3649 = ((_e3643 + 0f) - 0.5f);
let _e3650 = ((_e3645 + 0f) - 0.5f);
let _e3651 = ((_e3647 + -1f) - 0.5f);
let _e3653 = select(0f, _e3649, (_e3649 > 0f));
let _e3655 = select(_e2403, _e3653, (_e3653 < _e2403));
let _e3662 = select(0i, select(select(i32(_e3655), i32(-2147483648), (_e3655 < -2147483600f)), 2147483647i, (_e3655 > 2147483500f)), (_e3655 == _e3655));
let _e3666 = (_e3662 - select(0i, 1i, (_e3655 < f32(_e3662))));
let _e3668 = select(0f, _e3650, (_e3650 > 0f));
let _e3670 = select(_e2420, _e3668, (_e3668 < _e2420));
let _e3677 = select(0i, select(select(i32(_e3670), i32(-2147483648), (_e3670 < -2147483600f)), 2147483647i, (_e3670 > 2147483500f)), (_e3670 == _e3670));
let _e3681 = (_e3677 - select(0i, 1i, (_e3670 < f32(_e3677))));
let _e3683 = select(0f, _e3651, (_e3651 > 0f));
let _e3685 = select(_e2437, _e3683, (_e3683 < _e2437));
let _e3692 = select(0i, select(select(i32(_e3685), i32(-2147483648), (_e3685 < -2147483600f)), 2147483647i, (_e3685 > 2147483500f)), (_e3685 == _e3685));
let _e3696 = (_e3692 - select(0i, 1i, (_e3685 < f32(_e3692))));
let _e3697 = (_e3642 * 4i);
let _e3698 = (_e3697 + 1i);
let _e3700 = select(_e2456, _e3698, (_e3698 < _e2456));
let _e3705 = global_5.member[bitcast<u32>(select(0i, _e3700, (_e3700 > 0i)))];
let _e3706 = (_e3697 + 2i);
let _e3708 = select(_e2456, _e3706, (_e3706 < _e2456));
let _e3713 = global_5.member[bitcast<u32>(select(0i, _e3708, (_e3708 > 0i)))];
let _e3714 = (_e3697 + 3i);
let _e3716 = select(_e2456, _e3714, (_e3714 < _e2456));
let _e3721 = global_5.member[bitcast<u32>(select(0i, _e3716, (_e3716 > 0i)))];
let _e3724 = (_e3666 - bitcast<i32>((_e3705 & 65535u)));
let _e3729 = bitcast<i32>((_e3705 >> bitcast<u32>(16i)));
let _e3734 = (_e3681 - bitcast<i32>((_e3713 & 65535u)));
let _e3739 = bitcast<i32>((_e3713 >> bitcast<u32>(16i)));
let _e3744 = (_e3696 - bitcast<i32>((_e3721 & 65535u)));
if ((((_e3724 >= 0i) && ((_e3724 + 1i) < _e3729)) && ((_e3734 >= 0i) && ((_e3734 + 1i) < _e3739))) && ((_e3744 >= 0i) && ((_e3744 + 1i) < bitcast<i32>((_e3721 >> bitcast<u32>(16i)))))) {
let _e3754 = (_e3739 * _e3729);
let _e3756 = select(_e2456, _e3697, (_e3697 < _e2456));
let _e3761 = global_5.member[bitcast<u32>(select(0i, _e3756, (_e3756 > 0i)))];
let _e3767 = (((bitcast<i32>(_e3761) + (_e3744 * _e3754)) + (_e3734 * _e3729)) + _e3724);
let _e3769 = (_e3649 - f32(_e3666));
let _e3771 = (_e3650 - f32(_e3681));
let _e3774 = (2i * _e3767);
let _e3776 = (_e3774 >> bitcast<u32>(2i));
let _e3779 = bitcast<u32>(((_e3774 & 3i) * 8i));
let _e3781 = select(_e2456, _e3776, (_e3776 < _e2456));
let _e3786 = global_5.member[bitcast<u32>(select(0i, _e3781, (_e3781 > 0i)))];
let _e3790 = (_e3776 + 1i);
let _e3792 = select(_e2456, _e3790, (_e3790 < _e2456));
let _e3797 = global_5.member[bitcast<u32>(select(0i, _e3792, (_e3792 > 0i)))];
let _e3804 = ((_e3786 >> bitcast<u32>((_e3779 & 31u))) | ((_e3797 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3779) & 31u))));
let _e3807 = f32(bitcast<i32>((_e3804 & 65535u)));
let _e3814 = (_e3807 + ((f32(bitcast<i32>((_e3804 >> bitcast<u32>(16i)))) - _e3807) * _e3769));
let _e3816 = (2i * (_e3767 + _e3729));
let _e3818 = (_e3816 >> bitcast<u32>(2i));
let _e3821 = bitcast<u32>(((_e3816 & 3i) * 8i));
let _e3823 = select(_e2456, _e3818, (_e3818 < _e2456));
let _e3828 = global_5.member[bitcast<u32>(select(0i, _e3823, (_e3823 > 0i)))];
let _e3832 = (_e3818 + 1i);
let _e3834 = select(_e2456, _e3832, (_e3832 < _e2456));
let _e3839 = global_5.member[bitcast<u32>(select(0i, _e3834, (_e3834 > 0i)))];
let _e3846 = ((_e3828 >> bitcast<u32>((_e3821 & 31u))) | ((_e3839 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3821) & 31u))));
let _e3849 = f32(bitcast<i32>((_e3846 & 65535u)));
let _e3857 = (_e3767 + _e3754);
let _e3858 = (2i * _e3857);
let _e3860 = (_e3858 >> bitcast<u32>(2i));
let _e3863 = bitcast<u32>(((_e3858 & 3i) * 8i));
let _e3865 = select(_e2456, _e3860, (_e3860 < _e2456));
let _e3870 = global_5.member[bitcast<u32>(select(0i, _e3865, (_e3865 > 0i)))];
let _e3874 = (_e3860 + 1i);
let _e3876 = select(_e2456, _e3874, (_e3874 < _e2456));
let _e3881 = global_5.member[bitcast<u32>(select(0i, _e3876, (_e3876 > 0i)))];
let _e3888 = ((_e3870 >> bitcast<u32>((_e3863 & 31u))) | ((_e3881 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3863) & 31u))));
let _e3891 = f32(bitcast<i32>((_e3888 & 65535u)));
let _e3898 = (_e3891 + ((f32(bitcast<i32>((_e3888 >> bitcast<u32>(16i)))) - _e3891) * _e3769));
let _e3900 = (2i * (_e3857 + _e3729));
let _e3902 = (_e3900 >> bitcast<u32>(2i));
let _e3905 = bitcast<u32>(((_e3900 & 3i) * 8i));
let _e3907 = select(_e2456, _e3902, (_e3902 < _e2456));
let _e3912 = global_5.member[bitcast<u32>(select(0i, _e3907, (_e3907 > 0i)))];
let _e3916 = (_e3902 + 1i);
let _e3918 = select(_e2456, _e3916, (_e3916 < _e2456));
let _e3923 = global_5.member[bitcast<u32>(select(0i, _e3918, (_e3918 > 0i)))];
let _e3930 = ((_e3912 >> bitcast<u32>((_e3905 & 31u))) | ((_e3923 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3905) & 31u))));
let _e3933 = f32(bitcast<i32>((_e3930 & 65535u)));
let _e3943 = (_e3814 + (((_e3849 + ((f32(bitcast<i32>((_e3846 >> bitcast<u32>(16i)))) - _e3849) * _e3769)) - _e3814) * _e3771));
phi_5556_ = (_e3943 + (((_e3898 + (((_e3933 + ((f32(bitcast<i32>((_e3930 >> bitcast<u32>(16i)))) - _e3933) * _e3769)) - _e3898) * _e3771)) - _e3943) * (_e3651 - f32(_e3696))));
} else {
phi_5556_ = 0f;
}
let _e3951 = phi_5556_;
let _e3952 = local;
let _e3953 = local_1[0u];
let _e3955 = local_1[1u];
let _e3957 = local_1[2u];
let _e3959 = ((_e3953 + 0f) - 0.5f);
let _e3960 = ((_e3955 + 0f) - 0.5f);
let _e3961 = ((_e3957 + 1f) - 0.5f);
let _e3963 = select(0f, _e3959, (_e3959 > 0f));
let _e3965 = select(_e2403, _e3963, (_e3963 < _e2403));
let _e3972 = select(0i, select(select(i32(_e3965), i32(-2147483648), (_e3965 < -2147483600f)), 2147483647i, (_e3965 > 2147483500f)), (_e3965 == _e3965));
let _e3976 = (_e3972 - select(0i, 1i, (_e3965 < f32(_e3972))));
let _e3978 = select(0f, _e3960, (_e3960 > 0f));
let _e3980 = select(_e2420, _e3978, (_e3978 < _e2420));
let _e3987 = select(0i, select(select(i32(_e3980), i32(-2147483648), (_e3980 < -2147483600f)), 2147483647i, (_e3980 > 2147483500f)), (_e3980 == _e3980));
let _e3991 = (_e3987 - select(0i, 1i, (_e3980 < f32(_e3987))));
let _e3993 = select(0f, _e3961, (_e3961 > 0f));
let _e3995 = select(_e2437, _e3993, (_e3993 < _e2437));
let _e4002 = select(0i, select(select(i32(_e3995), i32(-2147483648), (_e3995 < -2147483600f)), 2147483647i, (_e3995 > 2147483500f)), (_e3995 == _e3995));
let _e4006 = (_e4002 - select(0i, 1i, (_e3995 < f32(_e4002))));
let _e4007 = (_e3952 * 4i);
let _e4008 = (_e4007 + 1i);
let _e4010 = select(_e2456, _e4008, (_e4008 < _e2456));
let _e4015 = global_5.member[bitcast<u32>(select(0i, _e4010, (_e4010 > 0i)))];
let _e4016 = (_e4007 + 2i);
let _e4018 = select(_e2456, _e4016, (_e4016 < _e2456));
let _e4023 = global_5.member[bitcast<u32>(select(0i, _e4018, (_e4018 > 0i)))];
let _e4024 = (_e4007 + 3i);
let _e4026 = select(_e2456, _e4024, (_e4024 < _e2456));
let _e4031 = global_5.member[bitcast<u32>(select(0i, _e4026, (_e4026 > 0i)))];
let _e4034 = (_e3976 - bitcast<i32>((_e4015 & 65535u)));
let _e4039 = bitcast<i32>((_e4015 >> bitcast<u32>(16i)));
let _e4044 = (_e3991 - bitcast<i32>((_e4023 & 65535u)));
let _e4049 = bitcast<i32>((_e4023 >> bitcast<u32>(16i)));
let _e4054 = (_e4006 - bitcast<i32>((_e4031 & 65535u)));
if ((((_e4034 >= 0i) && ((_e4034 + 1i) < _e4039)) && ((_e4044 >= 0i) && ((_e4044 + 1i) < _e4049))) && ((_e4054 >= 0i) && ((_e4054 + 1i) < bitcast<i32>((_e4031 >> bitcast<u32>(16i)))))) {
let _e4064 = (_e4049 * _e4039);
let _e4066 = select(_e2456, _e4007, (_e4007 < _e2456));
let _e4071 = global_5.member[bitcast<u32>(select(0i, _e4066, (_e4066 > 0i)))];
let _e4077 = (((bitcast<i32>(_e4071) + (_e4054 * _e4064)) + (_e4044 * _e4039)) + _e4034);
let _e4079 = (_e3959 - f32(_e3976));
let _e4081 = (_e3960 - f32(_e3991));
let _e4084 = (2i * _e4077);
let _e4086 = (_e4084 >> bitcast<u32>(2i));
let _e4089 = bitcast<u32>(((_e4084 & 3i) * 8i));
let _e4091 = select(_e2456, _e4086, (_e4086 < _e2456));
let _e4096 = global_5.member[bitcast<u32>(select(0i, _e4091, (_e4091 > 0i)))];
let _e4100 = (_e4086 + 1i);
let _e4102 = select(_e2456, _e4100, (_e4100 < _e2456));
let _e4107 = global_5.member[bitcast<u32>(select(0i, _e4102, (_e4102 > 0i)))];
let _e4114 = ((_e4096 >> bitcast<u32>((_e4089 & 31u))) | ((_e4107 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4089) & 31u))));
let _e4117 = f32(bitcast<i32>((_e4114 & 65535u)));
let _e4124 = (_e4117 + ((f32(bitcast<i32>((_e4114 >> bitcast<u32>(16i)))) - _e4117) * _e4079));
let _e4126 = (2i * (_e4077 + _e4039));
let _e4128 = (_e4126 >> bitcast<u32>(2i));
let _e4131 = bitcast<u32>(((_e4126 & 3i) * 8i));
let _e4133 = select(_e2456, _e4128, (_e4128 < _e2456));
let _e4138 = global_5.member[bitcast<u32>(select(0i, _e4133, (_e4133 > 0i)))];
let _e4142 = (_e4128 + 1i);
let _e4144 = select(_e2456, _e4142, (_e4142 < _e2456));
let _e4149 = global_5.member[bitcast<u32>(select(0i, _e4144, (_e4144 > 0i)))];
let _e4156 = ((_e4138 >> bitcast<u32>((_e4131 & 31u))) | ((_e4149 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4131) & 31u))));
let _e4159 = f32(bitcast<i32>((_e4156 & 65535u)));
let _e4167 = (_e4077 + _e4064);
let _e4168 = (2i * _e4167);
let _e4170 = (_e4168 >> bitcast<u32>(2i));
let _e4173 = bitcast<u32>(((_e4168 & 3i) * 8i));
let _e4175 = select(_e2456, _e4170, (_e4170 < _e2456));
let _e4180 = global_5.member[bitcast<u32>(select(0i, _e4175, (_e4175 > 0i)))];
let _e4184 = (_e4170 + 1i);
let _e4186 = select(_e2456, _e4184, (_e4184 < _e2456));
let _e4191 = global_5.member[bitcast<u32>(select(0i, _e4186, (_e4186 > 0i)))];
let _e4198 = ((_e4180 >> bitcast<u32>((_e4173 & 31u))) | ((_e4191 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4173) & 31u))));
let _e4201 = f32(bitcast<i32>((_e4198 & 65535u)));
let _e4208 = (_e4201 + ((f32(bitcast<i32>((_e4198 >> bitcast<u32>(16i)))) - _e4201) * _e4079));
let _e4210 = (2i * (_e4167 + _e4039));
let _e4212 = (_e4210 >> bitcast<u32>(2i));
let _e4215 = bitcast<u32>(((_e4210 & 3i) * 8i));
let _e4217 = select(_e2456, _e4212, (_e4212 < _e2456));
let _e4222 = global_5.member[bitcast<u32>(select(0i, _e4217, (_e4217 > 0i)))];
let _e4226 = (_e4212 + 1i);
let _e4228 = select(_e2456, _e4226, (_e4226 < _e2456));
let _e4233 = global_5.member[bitcast<u32>(select(0i, _e4228, (_e4228 > 0i)))];
let _e4240 = ((_e4222 >> bitcast<u32>((_e4215 & 31u))) | ((_e4233 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4215) & 31u))));
let _e4243 = f32(bitcast<i32>((_e4240 & 65535u)));
let _e4253 = (_e4124 + (((_e4159 + ((f32(bitcast<i32>((_e4156 >> bitcast<u32>(16i)))) - _e4159) * _e4079)) - _e4124) * _e4081));
phi_5995_ = (_e4253 + (((_e4208 + (((_e4243 + ((f32(bitcast<i32>((_e4240 >> bitcast<u32>(16i)))) - _e4243) * _e4079)) - _e4208) * _e4081)) - _e4253) * (_e3961 - f32(_e4006))));
} else {
phi_5995_ = 0f;
}
let _e4261 = phi_5995_;
let _e4262 = (_e3951 - _e4261);
let _e4267 = (((_e3020 * _e3020) + (_e3641 * _e3641)) + (_e4262 * _e4262));
let _e4270 = sqrt(select(0f, _e4267, (_e4267 > 0f)));
let _e4273 = (1f / select(1e-6f, _e4270, (_e4270 > 1e-6f)));
let _e4274 = (_e3020 * _e4273);
let _e4275 = (_e3641 * _e4273);
let _e4276 = (_e4262 * _e4273);
let _e4277 = vec3<f32>(_e4274, _e4275, _e4276);
let _e4280 = local_10;
let _e4281 = (_e1049.member_5 + _e4280);
let _e4284 = global_1.member.member_13;
let _e4297 = global_1.member.member_12;
let _e4301 = local_11;
let _e4303 = (((_e4281 < _e4284) && ((((_e4274 * _e1049.member_4.x) + (_e4275 * _e1049.member_4.y)) + (_e4276 * _e1049.member_4.z)) > _e4297)) || (_e4301 == _e1049.member_7));
if _e4303 {
phi_7439_ = _e1049;
} else {
let _e4335 = type_20(vec3<f32>((_e1049.member.x + _e2008), (_e1049.member.y + _e2011), (_e1049.member.z + _e2014)), _e1049.member_1, _e1049.member_2, _e1049.member_3, _e1049.member_4, _e1049.member_5, _e1049.member_6, _e1049.member_7, _e1049.member_8, _e1049.member_9, _e1049.member_10, _e1049.member_11, _e1049.member_12, _e1049.member_13, _e1049.member_14, _e1049.member_15, _e1049.member_16, _e1049.member_17, _e1049.member_18, _e1049.member_19, _e1049.member_20, _e1049.member_21);
let _e4357 = type_20(_e4335.member, _e4335.member_1, _e4335.member_2, _e4335.member_3, _e4335.member_4, _e4281, _e4335.member_6, _e4335.member_7, _e4335.member_8, _e4335.member_9, _e4335.member_10, _e4335.member_11, _e4335.member_12, _e4335.member_13, _e4335.member_14, _e4335.member_15, _e4335.member_16, _e4335.member_17, _e4335.member_18, _e4335.member_19, _e4335.member_20, _e4335.member_21);
let _e4361 = local_12;
let _e4386 = type_20(_e4357.member, _e4357.member_1, _e4357.member_2, _e4357.member_3, _e4357.member_4, _e4357.member_5, _e4357.member_6, _e4357.member_7, _e4357.member_8, _e4357.member_9, (_e1049.member_10 + select(0f, _e4361, (_e1049.member_8 == 0f))), _e4357.member_11, _e4357.member_12, _e4357.member_13, _e4357.member_14, _e4357.member_15, _e4357.member_16, _e4357.member_17, _e4357.member_18, _e4357.member_19, _e4357.member_20, _e4357.member_21);
if (_e1049.member_7 != 16i) {
let _e4390 = local_13;
let _e4413 = type_20(_e4386.member, _e4386.member_1, _e4386.member_2, _e4386.member_3, _e4386.member_4, _e4386.member_5, _e4386.member_6, _e4386.member_7, _e4386.member_8, (_e1049.member_9 + _e4390), _e4386.member_10, _e4386.member_11, _e4386.member_12, _e4386.member_13, _e4386.member_14, _e4386.member_15, _e4386.member_16, _e4386.member_17, _e4386.member_18, _e4386.member_19, _e4386.member_20, _e4386.member_21);
let _e4414 = (_e1049.member_7 * 4i);
let _e4415 = (_e4414 + 1i);
let _e4417 = (bitcast<i32>(_e112) - 1i);
let _e4419 = select(_e4417, _e4415, (_e4415 < _e4417));
let _e4425 = global_2.member[bitcast<u32>(select(0i, _e4419, (_e4419 > 0i)))];
let _e4427 = local_14;
let _e4429 = -((_e4425 * _e4427));
let _e4431 = select(-87f, _e4429, (_e4429 > -87f));
let _e4433 = select(88f, _e4431, (_e4431 < 88f));
let _e4435 = ((_e4433 * 1.442695f) + 0.5f);
let _e4437 = select(-127f, _e4435, (_e4435 > -127f));
let _e4439 = select(128f, _e4437, (_e4437 < 128f));
let _e4446 = select(0i, select(select(i32(_e4439), i32(-2147483648), (_e4439 < -2147483600f)), 2147483647i, (_e4439 > 2147483500f)), (_e4439 == _e4439));
let _e4450 = (_e4446 - select(0i, 1i, (_e4439 < f32(_e4446))));
let _e4451 = f32(_e4450);
let _e4455 = ((_e4433 - (_e4451 * 0.6933594f)) - (_e4451 * -2.1219444e-4f));
let _e4476 = (_e4414 + 2i);
let _e4478 = select(_e4417, _e4476, (_e4476 < _e4417));
let _e4484 = global_2.member[bitcast<u32>(select(0i, _e4478, (_e4478 > 0i)))];
let _e4486 = local_15;
let _e4488 = -((_e4484 * _e4486));
let _e4490 = select(-87f, _e4488, (_e4488 > -87f));
let _e4492 = select(88f, _e4490, (_e4490 < 88f));
let _e4494 = ((_e4492 * 1.442695f) + 0.5f);
let _e4496 = select(-127f, _e4494, (_e4494 > -127f));
let _e4498 = select(128f, _e4496, (_e4496 < 128f));
let _e4505 = select(0i, select(select(i32(_e4498), i32(-2147483648), (_e4498 < -2147483600f)), 2147483647i, (_e4498 > 2147483500f)), (_e4498 == _e4498));
let _e4509 = (_e4505 - select(0i, 1i, (_e4498 < f32(_e4505))));
let _e4510 = f32(_e4509);
let _e4514 = ((_e4492 - (_e4510 * 0.6933594f)) - (_e4510 * -2.1219444e-4f));
let _e4535 = (_e4414 + 3i);
let _e4537 = select(_e4417, _e4535, (_e4535 < _e4417));
let _e4543 = global_2.member[bitcast<u32>(select(0i, _e4537, (_e4537 > 0i)))];
let _e4545 = local_16;
let _e4547 = -((_e4543 * _e4545));
let _e4549 = select(-87f, _e4547, (_e4547 > -87f));
let _e4551 = select(88f, _e4549, (_e4549 < 88f));
let _e4553 = ((_e4551 * 1.442695f) + 0.5f);
let _e4555 = select(-127f, _e4553, (_e4553 > -127f));
let _e4557 = select(128f, _e4555, (_e4555 < 128f));
let _e4564 = select(0i, select(select(i32(_e4557), i32(-2147483648), (_e4557 < -2147483600f)), 2147483647i, (_e4557 > 2147483500f)), (_e4557 == _e4557));
let _e4568 = (_e4564 - select(0i, 1i, (_e4557 < f32(_e4564))));
let _e4569 = f32(_e4568);
let _e4573 = ((_e4551 - (_e4569 * 0.6933594f)) - (_e4569 * -2.1219444e-4f));
phi_6325_ = type_20(_e4413.member, _e4413.member_1, vec3<f32>((_e1049.member_2.x * ((1f + (_e4455 * (1f + (_e4455 * (0.5f + (_e4455 * (0.16666667f + (_e4455 * (0.041666668f + (_e4455 * (0.008333334f + (_e4455 * (0.001388889f + (_e4455 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4450 + 127i)) << bitcast<u32>(23i))))), (_e1049.member_2.y * ((1f + (_e4514 * (1f + (_e4514 * (0.5f + (_e4514 * (0.16666667f + (_e4514 * (0.041666668f + (_e4514 * (0.008333334f + (_e4514 * (0.001388889f + (_e4514 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4509 + 127i)) << bitcast<u32>(23i))))), (_e1049.member_2.z * ((1f + (_e4573 * (1f + (_e4573 * (0.5f + (_e4573 * (0.16666667f + (_e4573 * (0.041666668f + (_e4573 * (0.008333334f + (_e4573 * (0.001388889f + (_e4573 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4568 + 127i)) << bitcast<u32>(23i)))))), _e4413.member_3, _e4413.member_4, _e4413.member_5, _e4413.member_6, _e4413.member_7, _e4413.member_8, _e4413.member_9, _e4413.member_10, _e4413.member_11, _e4413.member_12, _e4413.member_13, _e4413.member_14, _e4413.member_15, _e4413.member_16, _e4413.member_17, _e4413.member_18, _e4413.member_19, _e4413.member_20, _e4413.member_21);
} else {
phi_6325_ = _e4386;
}
let _e4627 = phi_6325_;
let _e4629 = (_e1049.member_7 * 4i);
let _e4631 = (bitcast<i32>(_e112) - 1i);
let _e4633 = select(_e4631, _e4629, (_e4629 < _e4631));
let _e4639 = global_2.member[bitcast<u32>(select(0i, _e4633, (_e4633 > 0i)))];
let _e4640 = (_e1049.member_7 == 16i);
let _e4641 = select(_e4639, 1f, _e4640);
let _e4643 = local_17;
let _e4644 = (_e4643 * 4i);
let _e4646 = select(_e4631, _e4644, (_e4644 < _e4631));
let _e4652 = global_2.member[bitcast<u32>(select(0i, _e4646, (_e4646 > 0i)))];
let _e4654 = local_18;
let _e4656 = select(_e4652, 1f, (_e4654 == 16i));
let _e4666 = select(1f, -1f, ((((_e4627.member_1.x * _e4274) + (_e4627.member_1.y * _e4275)) + (_e4627.member_1.z * _e4276)) > 0f));
let _e4667 = (_e4274 * _e4666);
let _e4668 = (_e4275 * _e4666);
let _e4669 = (_e4276 * _e4666);
let _e4675 = -((((_e4627.member_1.x * _e4667) + (_e4627.member_1.y * _e4668)) + (_e4627.member_1.z * _e4669)));
let _e4677 = select(0f, _e4675, (_e4675 > 0f));
let _e4678 = (_e4641 / _e4656);
let _e4680 = (_e4677 * _e4677);
let _e4683 = (1f - ((_e4678 * _e4678) * (1f - _e4680)));
let _e4684 = (_e4683 <= 0f);
let _e4692 = ((_e4678 * _e4677) - sqrt(select(0f, _e4683, (_e4683 > 0f))));
let _e4699 = (2f * _e4677);
let _e4700 = (_e4667 * _e4699);
let _e4701 = (_e4668 * _e4699);
let _e4702 = (_e4669 * _e4699);
let _e4708 = select(((_e4627.member_1.x * _e4678) + (_e4667 * _e4692)), (_e4627.member_1.x + _e4700), _e4684);
let _e4709 = select(((_e4627.member_1.y * _e4678) + (_e4668 * _e4692)), (_e4627.member_1.y + _e4701), _e4684);
let _e4710 = select(((_e4627.member_1.z * _e4678) + (_e4669 * _e4692)), (_e4627.member_1.z + _e4702), _e4684);
let _e4715 = (((_e4708 * _e4708) + (_e4709 * _e4709)) + (_e4710 * _e4710));
let _e4718 = sqrt(select(0f, _e4715, (_e4715 > 0f)));
let _e4721 = (1f / select(1e-20f, _e4718, (_e4718 > 1e-20f)));
let _e4726 = (_e4656 / _e4641);
let _e4729 = (((_e4726 * _e4726) - 1f) + _e4680);
let _e4732 = sqrt(select(0f, _e4729, (_e4729 > 0f)));
let _e4733 = (_e4732 - _e4677);
let _e4734 = (_e4732 + _e4677);
let _e4737 = (_e4733 / select(1e-6f, _e4734, (_e4734 > 1e-6f)));
let _e4741 = ((_e4677 * _e4733) + 1f);
let _e4744 = (((_e4677 * _e4734) - 1f) / select(1e-6f, _e4741, (_e4741 > 1e-6f)));
let _e4755 = (_e4627.member_8 == 0f);
let _e4758 = global_1.member.member_1;
let _e4761 = select(0f, select(select((((0.5f * _e4737) * _e4737) * (1f + (_e4744 * _e4744))), 1f, (_e4729 <= 0f)), 0f, (_e4641 == _e4656)), ((_e4758 & 1u) != 0u));
let _e4762 = (_e4755 && _e4640);
if _e4755 {
let _e4784 = type_20(_e4627.member, _e4627.member_1, _e4627.member_2, _e4277, _e4627.member_4, _e4627.member_5, _e4627.member_6, _e4627.member_7, _e4627.member_8, _e4627.member_9, _e4627.member_10, _e4627.member_11, _e4627.member_12, _e4627.member_13, _e4627.member_14, _e4627.member_15, _e4627.member_16, _e4627.member_17, _e4627.member_18, _e4627.member_19, _e4627.member_20, _e4627.member_21);
phi_6544_ = type_20(_e4784.member, _e4784.member_1, _e4784.member_2, _e4784.member_3, _e4784.member_4, _e4784.member_5, _e4784.member_6, _e4784.member_7, _e4784.member_8, _e4784.member_9, _e4784.member_10, select(0f, _e4761, _e4762), _e4784.member_12, _e4784.member_13, _e4784.member_14, _e4784.member_15, _e4784.member_16, _e4784.member_17, _e4784.member_18, _e4784.member_19, _e4784.member_20, _e4784.member_21);
} else {
phi_6544_ = _e4627;
}
let _e4809 = phi_6544_;
let _e4811 = !(_e4684);
if (!(_e4762) && _e4811) {
let _e4817 = select(_e4809.member_5, _e4809.member_9, (_e4809.member_8 == 0f));
let _e4818 = (_e4629 + 1i);
let _e4820 = select(_e4631, _e4818, (_e4818 < _e4631));
let _e4826 = global_2.member[bitcast<u32>(select(0i, _e4820, (_e4820 > 0i)))];
let _e4828 = -((_e4826 * _e4817));
let _e4830 = select(-87f, _e4828, (_e4828 > -87f));
let _e4832 = select(88f, _e4830, (_e4830 < 88f));
let _e4834 = ((_e4832 * 1.442695f) + 0.5f);
let _e4836 = select(-127f, _e4834, (_e4834 > -127f));
let _e4838 = select(128f, _e4836, (_e4836 < 128f));
let _e4845 = select(0i, select(select(i32(_e4838), i32(-2147483648), (_e4838 < -2147483600f)), 2147483647i, (_e4838 > 2147483500f)), (_e4838 == _e4838));
let _e4849 = (_e4845 - select(0i, 1i, (_e4838 < f32(_e4845))));
let _e4850 = f32(_e4849);
let _e4854 = ((_e4832 - (_e4850 * 0.6933594f)) - (_e4850 * -2.1219444e-4f));
let _e4875 = (_e4629 + 2i);
let _e4877 = select(_e4631, _e4875, (_e4875 < _e4631));
let _e4883 = global_2.member[bitcast<u32>(select(0i, _e4877, (_e4877 > 0i)))];
let _e4885 = -((_e4883 * _e4817));
let _e4887 = select(-87f, _e4885, (_e4885 > -87f));
let _e4889 = select(88f, _e4887, (_e4887 < 88f));
let _e4891 = ((_e4889 * 1.442695f) + 0.5f);
let _e4893 = select(-127f, _e4891, (_e4891 > -127f));
let _e4895 = select(128f, _e4893, (_e4893 < 128f));
let _e4902 = select(0i, select(select(i32(_e4895), i32(-2147483648), (_e4895 < -2147483600f)), 2147483647i, (_e4895 > 2147483500f)), (_e4895 == _e4895));
let _e4906 = (_e4902 - select(0i, 1i, (_e4895 < f32(_e4902))));
let _e4907 = f32(_e4906);
let _e4911 = ((_e4889 - (_e4907 * 0.6933594f)) - (_e4907 * -2.1219444e-4f));
let _e4932 = (_e4629 + 3i);
let _e4934 = select(_e4631, _e4932, (_e4932 < _e4631));
let _e4940 = global_2.member[bitcast<u32>(select(0i, _e4934, (_e4934 > 0i)))];
let _e4942 = -((_e4940 * _e4817));
let _e4944 = select(-87f, _e4942, (_e4942 > -87f));
let _e4946 = select(88f, _e4944, (_e4944 < 88f));
let _e4948 = ((_e4946 * 1.442695f) + 0.5f);
let _e4950 = select(-127f, _e4948, (_e4948 > -127f));
let _e4952 = select(128f, _e4950, (_e4950 < 128f));
let _e4959 = select(0i, select(select(i32(_e4952), i32(-2147483648), (_e4952 < -2147483600f)), 2147483647i, (_e4952 > 2147483500f)), (_e4952 == _e4952));
let _e4963 = (_e4959 - select(0i, 1i, (_e4952 < f32(_e4959))));
let _e4964 = f32(_e4963);
let _e4968 = ((_e4946 - (_e4964 * 0.6933594f)) - (_e4964 * -2.1219444e-4f));
let _e4990 = select(((1f + (_e4854 * (1f + (_e4854 * (0.5f + (_e4854 * (0.16666667f + (_e4854 * (0.041666668f + (_e4854 * (0.008333334f + (_e4854 * (0.001388889f + (_e4854 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4849 + 127i)) << bitcast<u32>(23i)))), 1f, _e4640);
let _e4992 = (1f - (_e4761 * _e4990));
let _e4994 = (1f - _e4761);
let _e5000 = select(((1f + (_e4911 * (1f + (_e4911 * (0.5f + (_e4911 * (0.16666667f + (_e4911 * (0.041666668f + (_e4911 * (0.008333334f + (_e4911 * (0.001388889f + (_e4911 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4906 + 127i)) << bitcast<u32>(23i)))), 1f, _e4640);
let _e5002 = (1f - (_e4761 * _e5000));
let _e5009 = select(((1f + (_e4968 * (1f + (_e4968 * (0.5f + (_e4968 * (0.16666667f + (_e4968 * (0.041666668f + (_e4968 * (0.008333334f + (_e4968 * (0.001388889f + (_e4968 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4963 + 127i)) << bitcast<u32>(23i)))), 1f, _e4640);
let _e5011 = (1f - (_e4761 * _e5009));
let _e5024 = ((_e4809.member_2.x * select(1f, ((_e4994 * _e4990) / select(1e-9f, _e4992, (_e4992 > 1e-9f))), (_e4992 > 0f))) * _e4761);
let _e5025 = ((_e4809.member_2.y * select(1f, ((_e4994 * _e5000) / select(1e-9f, _e5002, (_e5002 > 1e-9f))), (_e5002 > 0f))) * _e4761);
let _e5026 = ((_e4809.member_2.z * select(1f, ((_e4994 * _e5009) / select(1e-9f, _e5011, (_e5011 > 1e-9f))), (_e5011 > 0f))) * _e4761);
if (((_e4758 & 8u) != 0u) && (((_e5024 + _e5025) + _e5026) > ((_e4809.member_17.x + _e4809.member_17.y) + _e4809.member_17.z))) {
let _e5103 = type_20(_e4809.member, _e4809.member_1, _e4809.member_2, _e4809.member_3, _e4809.member_4, _e4809.member_5, _e4809.member_6, _e4809.member_7, _e4809.member_8, _e4809.member_9, _e4809.member_10, _e4809.member_11, vec3<f32>((_e4809.member_12.x + _e4809.member_17.x), (_e4809.member_12.y + _e4809.member_17.y), (_e4809.member_12.z + _e4809.member_17.z)), _e4809.member_13, _e4809.member_14, _e4809.member_15, _e4809.member_16, _e4809.member_17, _e4809.member_18, _e4809.member_19, _e4809.member_20, _e4809.member_21);
let _e5126 = type_20(_e5103.member, _e5103.member_1, _e5103.member_2, _e5103.member_3, _e5103.member_4, _e5103.member_5, _e5103.member_6, _e5103.member_7, _e5103.member_8, _e5103.member_9, _e5103.member_10, _e5103.member_11, _e5103.member_12, _e4809.member, _e5103.member_14, _e5103.member_15, _e5103.member_16, _e5103.member_17, _e5103.member_18, _e5103.member_19, _e5103.member_20, _e5103.member_21);
let _e5148 = type_20(_e5126.member, _e5126.member_1, _e5126.member_2, _e5126.member_3, _e5126.member_4, _e5126.member_5, _e5126.member_6, _e5126.member_7, _e5126.member_8, _e5126.member_9, _e5126.member_10, _e5126.member_11, _e5126.member_12, _e5126.member_13, (_e4627.member_1 + vec3<f32>(_e4700, _e4701, _e4702)), _e5126.member_15, _e5126.member_16, _e5126.member_17, _e5126.member_18, _e5126.member_19, _e5126.member_20, _e5126.member_21);
let _e5170 = type_20(_e5148.member, _e5148.member_1, _e5148.member_2, _e5148.member_3, _e5148.member_4, _e5148.member_5, _e5148.member_6, _e5148.member_7, _e5148.member_8, _e5148.member_9, _e5148.member_10, _e5148.member_11, _e5148.member_12, _e5148.member_13, _e5148.member_14, _e4277, _e5148.member_16, _e5148.member_17, _e5148.member_18, _e5148.member_19, _e5148.member_20, _e5148.member_21);
let _e5193 = type_20(_e5170.member, _e5170.member_1, _e5170.member_2, _e5170.member_3, _e5170.member_4, _e5170.member_5, _e5170.member_6, _e5170.member_7, _e5170.member_8, _e5170.member_9, _e5170.member_10, _e5170.member_11, _e5170.member_12, _e5170.member_13, _e5170.member_14, _e5170.member_15, (_e4809.member_2 * _e4761), _e5170.member_17, _e5170.member_18, _e5170.member_19, _e5170.member_20, _e5170.member_21);
let _e5215 = type_20(_e5193.member, _e5193.member_1, _e5193.member_2, _e5193.member_3, _e5193.member_4, _e5193.member_5, _e5193.member_6, _e5193.member_7, _e5193.member_8, _e5193.member_9, _e5193.member_10, _e5193.member_11, _e5193.member_12, _e5193.member_13, _e5193.member_14, _e5193.member_15, _e5193.member_16, vec3<f32>(_e5024, _e5025, _e5026), _e5193.member_18, _e5193.member_19, _e5193.member_20, _e5193.member_21);
phi_6916_ = type_20(_e5215.member, _e5215.member_1, _e5215.member_2, _e5215.member_3, _e5215.member_4, _e5215.member_5, _e5215.member_6, _e5215.member_7, _e5215.member_8, _e5215.member_9, _e5215.member_10, _e5215.member_11, _e5215.member_12, _e5215.member_13, _e5215.member_14, _e5215.member_15, _e5215.member_16, _e5215.member_17, _e4809.member_7, _e5215.member_19, _e5215.member_20, _e5215.member_21);
} else {
phi_6916_ = type_20(_e4809.member, _e4809.member_1, _e4809.member_2, _e4809.member_3, _e4809.member_4, _e4809.member_5, _e4809.member_6, _e4809.member_7, _e4809.member_8, _e4809.member_9, _e4809.member_10, _e4809.member_11, vec3<f32>((_e4809.member_12.x + _e5024), (_e4809.member_12.y + _e5025), (_e4809.member_12.z + _e5026)), _e4809.member_13, _e4809.member_14, _e4809.member_15, _e4809.member_16, _e4809.member_17, _e4809.member_18, _e4809.member_19, _e4809.member_20, _e4809.member_21);
}
let _e5240 = phi_6916_;
phi_6917_ = _e5240;
} else {
phi_6917_ = _e4809;
}
let _e5242 = phi_6917_;
let _e5244 = (_e5242.member_8 + 1f);
let _e5266 = type_20(_e5242.member, _e5242.member_1, _e5242.member_2, _e5242.member_3, _e5242.member_4, _e5242.member_5, _e5242.member_6, _e5242.member_7, _e5244, _e5242.member_9, _e5242.member_10, _e5242.member_11, _e5242.member_12, _e5242.member_13, _e5242.member_14, _e5242.member_15, _e5242.member_16, _e5242.member_17, _e5242.member_18, _e5242.member_19, _e5242.member_20, _e5242.member_21);
let _e5269 = ((_e119.member_2 == 0u) && (_e5244 >= 2f));
if (_e4684 && _e5269) {
let _e5301 = (((_e5242.member_1.x * _e4274) + (_e5242.member_1.y * _e4275)) + (_e5242.member_1.z * _e4276));
let _e5305 = (_e5242.member_1.x - (_e4274 * _e5301));
let _e5306 = (_e5242.member_1.y - (_e4275 * _e5301));
let _e5307 = (_e5242.member_1.z - (_e4276 * _e5301));
let _e5312 = (((_e5305 * _e5305) + (_e5306 * _e5306)) + (_e5307 * _e5307));
let _e5315 = sqrt(select(0f, _e5312, (_e5312 > 0f)));
let _e5318 = (1f / select(1e-20f, _e5315, (_e5315 > 1e-20f)));
phi_6970_ = type_20(_e5266.member, vec3<f32>((_e5305 * _e5318), (_e5306 * _e5318), (_e5307 * _e5318)), _e5266.member_2, _e5266.member_3, _e5266.member_4, _e5266.member_5, _e5266.member_6, _e5266.member_7, _e5266.member_8, _e5266.member_9, _e5266.member_10, _e5266.member_11, _e5266.member_12, _e5266.member_13, _e5266.member_14, _e5266.member_15, _e5266.member_16, _e5266.member_17, _e5266.member_18, _e5266.member_19, _e5266.member_20, _e5266.member_21);
} else {
phi_6970_ = type_20(_e5266.member, vec3<f32>((_e4708 * _e4721), (_e4709 * _e4721), (_e4710 * _e4721)), _e5266.member_2, _e5266.member_3, _e5266.member_4, _e5266.member_5, _e5266.member_6, _e5266.member_7, _e5266.member_8, _e5266.member_9, _e5266.member_10, _e5266.member_11, _e5266.member_12, _e5266.member_13, _e5266.member_14, _e5266.member_15, _e5266.member_16, _e5266.member_17, _e5266.member_18, _e5266.member_19, _e5266.member_20, _e5266.member_21);
}
let _e5346 = phi_6970_;
if _e4684 {
phi_6984_ = _e5346;
} else {
let _e5347 = (1f - _e4761);
phi_6984_ = type_20(_e5346.member, _e5346.member_1, vec3<f32>((_e5346.member_2.x * _e5347), (_e5346.member_2.y * _e5347), (_e5346.member_2.z * _e5347)), _e5346.member_3, _e5346.member_4, _e5346.member_5, _e5346.member_6, _e5346.member_7, _e5346.member_8, _e5346.member_9, _e5346.member_10, _e5346.member_11, _e5346.member_12, _e5346.member_13, _e5346.member_14, _e5346.member_15, _e5346.member_16, _e5346.member_17, _e5346.member_18, _e5346.member_19, _e5346.member_20, _e5346.member_21);
}
let _e5381 = phi_6984_;
let _e5403 = type_20(_e5381.member, _e5381.member_1, _e5381.member_2, _e5381.member_3, _e5381.member_4, 0f, _e5381.member_6, _e5381.member_7, _e5381.member_8, _e5381.member_9, _e5381.member_10, _e5381.member_11, _e5381.member_12, _e5381.member_13, _e5381.member_14, _e5381.member_15, _e5381.member_16, _e5381.member_17, _e5381.member_18, _e5381.member_19, _e5381.member_20, _e5381.member_21);
let _e5410 = global_1.member.member_18.member.member;
let _e5424 = ((((_e5410.member.member * _e5381.member.x) + (_e5410.member.member_1 * _e5381.member.y)) + (_e5410.member.member_2 * _e5381.member.z)) + _e5410.member_1);
let _e5433 = -((((_e5410.member.member * _e5381.member_1.x) + (_e5410.member.member_1 * _e5381.member_1.y)) + (_e5410.member.member_2 * _e5381.member_1.z)));
let _e5435 = (_e5433 > 1e-9f);
let _e5439 = ((_e5424 / select(1e-9f, _e5433, _e5435)) - 0.015625f);
let _e5442 = select(1e30f, select(0f, _e5439, (_e5439 > 0f)), ((_e5424 > 0f) && _e5435));
let _e5447 = global_1.member.member_18.member_1.member;
let _e5458 = ((((_e5447.member.member * _e5381.member.x) + (_e5447.member.member_1 * _e5381.member.y)) + (_e5447.member.member_2 * _e5381.member.z)) + _e5447.member_1);
let _e5464 = -((((_e5447.member.member * _e5381.member_1.x) + (_e5447.member.member_1 * _e5381.member_1.y)) + (_e5447.member.member_2 * _e5381.member_1.z)));
let _e5466 = (_e5464 > 1e-9f);
let _e5470 = ((_e5458 / select(1e-9f, _e5464, _e5466)) - 0.015625f);
let _e5473 = select(1e30f, select(0f, _e5470, (_e5470 > 0f)), ((_e5458 > 0f) && _e5466));
let _e5477 = (_e5473 < _e5442);
let _e5479 = select(select(-2i, -3i, _e5477), -1i, ((_e5442 >= 1e30f) && (_e5473 >= 1e30f)));
let _e5480 = select(_e5442, _e5473, _e5477);
let _e5502 = type_20(_e5403.member, _e5403.member_1, _e5403.member_2, _e5403.member_3, _e5403.member_4, _e5403.member_5, _e5403.member_6, _e5403.member_7, _e5403.member_8, _e5403.member_9, _e5403.member_10, _e5403.member_11, _e5403.member_12, _e5403.member_13, _e5403.member_14, _e5403.member_15, _e5403.member_16, _e5403.member_17, _e5403.member_18, 0i, _e5403.member_20, _e5403.member_21);
let _e5524 = type_20(_e5502.member, _e5502.member_1, _e5502.member_2, _e5502.member_3, _e5502.member_4, _e5502.member_5, _e5502.member_6, _e5502.member_7, _e5502.member_8, _e5502.member_9, _e5502.member_10, _e5502.member_11, _e5502.member_12, _e5502.member_13, _e5502.member_14, _e5502.member_15, _e5502.member_16, _e5502.member_17, _e5502.member_18, _e5502.member_19, _e5479, _e5502.member_21);
let _e5546 = type_20(_e5524.member, _e5524.member_1, _e5524.member_2, _e5524.member_3, _e5524.member_4, _e5524.member_5, _e5524.member_6, _e5524.member_7, _e5524.member_8, _e5524.member_9, _e5524.member_10, _e5524.member_11, _e5524.member_12, _e5524.member_13, _e5524.member_14, _e5524.member_15, _e5524.member_16, _e5524.member_17, _e5524.member_18, _e5524.member_19, _e5524.member_20, _e5480);
let _e5548 = local_19;
let _e5551 = ((_e4758 & 2u) != 0u);
if (_e5269 && !(_e5551)) {
if (_e5479 == -1i) {
phi_7410_ = type_20(_e5546.member, _e5546.member_1, _e5546.member_2, _e5546.member_3, _e5546.member_4, _e5546.member_5, 1f, _e5546.member_7, _e5546.member_8, _e5546.member_9, _e5546.member_10, _e5546.member_11, _e5546.member_12, _e5546.member_13, _e5546.member_14, _e5546.member_15, _e5546.member_16, _e5546.member_17, _e5546.member_18, _e5546.member_19, _e5546.member_20, _e5546.member_21);
} else {
let _e5648 = type_20(vec3<f32>((_e5381.member.x + (_e5381.member_1.x * _e5480)), (_e5381.member.y + (_e5381.member_1.y * _e5480)), (_e5381.member.z + (_e5381.member_1.z * _e5480))), _e5546.member_1, _e5546.member_2, _e5546.member_3, _e5546.member_4, _e5546.member_5, _e5546.member_6, _e5546.member_7, _e5546.member_8, _e5546.member_9, _e5546.member_10, _e5546.member_11, _e5546.member_12, _e5546.member_13, _e5546.member_14, _e5546.member_15, _e5546.member_16, _e5546.member_17, _e5546.member_18, _e5546.member_19, _e5546.member_20, _e5546.member_21);
let _e5671 = type_20(_e5648.member, _e5648.member_1, _e5648.member_2, _e5648.member_3, _e5648.member_4, (0f + _e5480), _e5648.member_6, _e5648.member_7, _e5648.member_8, _e5648.member_9, _e5648.member_10, _e5648.member_11, _e5648.member_12, _e5648.member_13, _e5648.member_14, _e5648.member_15, _e5648.member_16, _e5648.member_17, _e5648.member_18, _e5648.member_19, _e5648.member_20, _e5648.member_21);
let _e5694 = type_20(_e5671.member, _e5671.member_1, _e5671.member_2, _e5671.member_3, _e5671.member_4, _e5671.member_5, _e5671.member_6, _e5671.member_7, _e5671.member_8, _e5671.member_9, _e5671.member_10, _e5671.member_11, _e5671.member_12, _e5671.member_13, _e5671.member_14, _e5671.member_15, _e5671.member_16, _e5671.member_17, _e5671.member_18, _e5671.member_19, _e5671.member_20, (_e5480 - _e5480));
let _e5721 = type_20(_e5694.member, _e5694.member_1, _e5694.member_2, _e5694.member_3, _e5694.member_4, _e5694.member_5, _e5694.member_6, _e5694.member_7, _e5694.member_8, _e5694.member_9, (_e5381.member_10 + select(0f, _e5480, (_e5381.member_8 == 0f))), _e5694.member_11, _e5694.member_12, _e5694.member_13, _e5694.member_14, _e5694.member_15, _e5694.member_16, _e5694.member_17, _e5694.member_18, _e5694.member_19, _e5694.member_20, _e5694.member_21);
phi_7410_ = type_20(_e5721.member, _e5721.member_1, _e5721.member_2, _e5721.member_3, _e5721.member_4, _e5721.member_5, 3f, _e5721.member_7, _e5721.member_8, _e5721.member_9, _e5721.member_10, _e5721.member_11, _e5721.member_12, _e5721.member_13, _e5721.member_14, _e5721.member_15, _e5721.member_16, _e5721.member_17, _e5721.member_18, _e5721.member_19, _e5721.member_20, _e5721.member_21);
}
let _e5767 = phi_7410_;
phi_7431_ = _e5767;
} else {
let _e5558 = global_1.member.member_5;
if ((!(_e5269) && (_e5381.member_8 >= f32(bitcast<i32>(_e5558)))) && (select(_e5548, _e1049.member_7, _e4684) != 16i)) {
phi_7430_ = type_20(_e5546.member, _e5546.member_1, _e5546.member_2, _e5546.member_3, _e5546.member_4, _e5546.member_5, 2f, _e5546.member_7, _e5546.member_8, _e5546.member_9, _e5546.member_10, _e5546.member_11, _e5546.member_12, _e5546.member_13, _e5546.member_14, _e5546.member_15, _e5546.member_16, _e5546.member_17, _e5546.member_18, _e5546.member_19, _e5546.member_20, _e5546.member_21);
} else {
if _e5551 {
phi_7429_ = type_20(_e5546.member, _e5546.member_1, _e5546.member_2, _e5546.member_3, _e5546.member_4, _e5546.member_5, 4f, _e5546.member_7, _e5546.member_8, _e5546.member_9, _e5546.member_10, _e5546.member_11, _e5546.member_12, _e5546.member_13, _e5546.member_14, _e5546.member_15, _e5546.member_16, _e5546.member_17, _e5546.member_18, _e5546.member_19, _e5546.member_20, _e5546.member_21);
} else {
phi_7429_ = _e5546;
}
let _e5588 = phi_7429_;
phi_7430_ = _e5588;
}
let _e5612 = phi_7430_;
phi_7431_ = _e5612;
}
let _e5769 = phi_7431_;
let _e5771 = local_20;
let _e5794 = type_20(_e5769.member, _e5769.member_1, _e5769.member_2, _e5769.member_3, _e5769.member_4, _e5769.member_5, _e5769.member_6, select(_e1049.member_7, _e5771, _e4811), _e5769.member_8, _e5769.member_9, _e5769.member_10, _e5769.member_11, _e5769.member_12, _e5769.member_13, _e5769.member_14, _e5769.member_15, _e5769.member_16, _e5769.member_17, _e5769.member_18, _e5769.member_19, _e5769.member_20, _e5769.member_21);
phi_7439_ = type_20(_e5794.member, _e5794.member_1, _e5794.member_2, _e5794.member_3, _e4277, _e5794.member_5, _e5794.member_6, _e5794.member_7, _e5794.member_8, _e5794.member_9, _e5794.member_10, _e5794.member_11, _e5794.member_12, _e5794.member_13, _e5794.member_14, _e5794.member_15, _e5794.member_16, _e5794.member_17, _e5794.member_18, _e5794.member_19, _e5794.member_20, _e5794.member_21);
}
let _e5818 = phi_7439_;
phi_7440_ = _e5818;
phi_7441_ = _e4303;
}
let _e5820 = phi_7440_;
let _e5822 = phi_7441_;
if (_e5822 && _e1259) {
let _e6383 = type_20(vec3<f32>((_e5820.member.x + (_e5820.member_1.x * _e5820.member_21)), (_e5820.member.y + (_e5820.member_1.y * _e5820.member_21)), (_e5820.member.z + (_e5820.member_1.z * _e5820.member_21))), _e5820.member_1, _e5820.member_2, _e5820.member_3, _e5820.member_4, _e5820.member_5, _e5820.member_6, _e5820.member_7, _e5820.member_8, _e5820.member_9, _e5820.member_10, _e5820.member_11, _e5820.member_12, _e5820.member_13, _e5820.member_14, _e5820.member_15, _e5820.member_16, _e5820.member_17, _e5820.member_18, _e5820.member_19, _e5820.member_20, _e5820.member_21);
let _e6407 = type_20(_e6383.member, _e6383.member_1, _e6383.member_2, _e6383.member_3, _e6383.member_4, (_e5820.member_5 + _e5820.member_21), _e6383.member_6, _e6383.member_7, _e6383.member_8, _e6383.member_9, _e6383.member_10, _e6383.member_11, _e6383.member_12, _e6383.member_13, _e6383.member_14, _e6383.member_15, _e6383.member_16, _e6383.member_17, _e6383.member_18, _e6383.member_19, _e6383.member_20, _e6383.member_21);
let _e6430 = type_20(_e6407.member, _e6407.member_1, _e6407.member_2, _e6407.member_3, _e6407.member_4, _e6407.member_5, _e6407.member_6, _e6407.member_7, _e6407.member_8, _e6407.member_9, _e6407.member_10, _e6407.member_11, _e6407.member_12, _e6407.member_13, _e6407.member_14, _e6407.member_15, _e6407.member_16, _e6407.member_17, _e6407.member_18, _e6407.member_19, _e6407.member_20, (_e5820.member_21 - _e5820.member_21));
let _e6457 = type_20(_e6430.member, _e6430.member_1, _e6430.member_2, _e6430.member_3, _e6430.member_4, _e6430.member_5, _e6430.member_6, _e6430.member_7, _e6430.member_8, _e6430.member_9, (_e5820.member_10 + select(0f, _e5820.member_21, (_e5820.member_8 == 0f))), _e6430.member_11, _e6430.member_12, _e6430.member_13, _e6430.member_14, _e6430.member_15, _e6430.member_16, _e6430.member_17, _e6430.member_18, _e6430.member_19, _e6430.member_20, _e6430.member_21);
if (_e1049.member_7 != 16i) {
let _e6482 = type_20(_e6457.member, _e6457.member_1, _e6457.member_2, _e6457.member_3, _e6457.member_4, _e6457.member_5, _e6457.member_6, _e6457.member_7, _e6457.member_8, (_e5820.member_9 + _e5820.member_21), _e6457.member_10, _e6457.member_11, _e6457.member_12, _e6457.member_13, _e6457.member_14, _e6457.member_15, _e6457.member_16, _e6457.member_17, _e6457.member_18, _e6457.member_19, _e6457.member_20, _e6457.member_21);
let _e6483 = (_e1049.member_7 * 4i);
let _e6484 = (_e6483 + 1i);
let _e6486 = (bitcast<i32>(_e112) - 1i);
let _e6488 = select(_e6486, _e6484, (_e6484 < _e6486));
let _e6494 = global_2.member[bitcast<u32>(select(0i, _e6488, (_e6488 > 0i)))];
let _e6496 = -((_e6494 * _e5820.member_21));
let _e6498 = select(-87f, _e6496, (_e6496 > -87f));
let _e6500 = select(88f, _e6498, (_e6498 < 88f));
let _e6502 = ((_e6500 * 1.442695f) + 0.5f);
let _e6504 = select(-127f, _e6502, (_e6502 > -127f));
let _e6506 = select(128f, _e6504, (_e6504 < 128f));
let _e6513 = select(0i, select(select(i32(_e6506), i32(-2147483648), (_e6506 < -2147483600f)), 2147483647i, (_e6506 > 2147483500f)), (_e6506 == _e6506));
let _e6517 = (_e6513 - select(0i, 1i, (_e6506 < f32(_e6513))));
let _e6518 = f32(_e6517);
let _e6522 = ((_e6500 - (_e6518 * 0.6933594f)) - (_e6518 * -2.1219444e-4f));
let _e6543 = (_e6483 + 2i);
let _e6545 = select(_e6486, _e6543, (_e6543 < _e6486));
let _e6551 = global_2.member[bitcast<u32>(select(0i, _e6545, (_e6545 > 0i)))];
let _e6553 = -((_e6551 * _e5820.member_21));
let _e6555 = select(-87f, _e6553, (_e6553 > -87f));
let _e6557 = select(88f, _e6555, (_e6555 < 88f));
let _e6559 = ((_e6557 * 1.442695f) + 0.5f);
let _e6561 = select(-127f, _e6559, (_e6559 > -127f));
let _e6563 = select(128f, _e6561, (_e6561 < 128f));
let _e6570 = select(0i, select(select(i32(_e6563), i32(-2147483648), (_e6563 < -2147483600f)), 2147483647i, (_e6563 > 2147483500f)), (_e6563 == _e6563));
let _e6574 = (_e6570 - select(0i, 1i, (_e6563 < f32(_e6570))));
let _e6575 = f32(_e6574);
let _e6579 = ((_e6557 - (_e6575 * 0.6933594f)) - (_e6575 * -2.1219444e-4f));
let _e6600 = (_e6483 + 3i);
let _e6602 = select(_e6486, _e6600, (_e6600 < _e6486));
let _e6608 = global_2.member[bitcast<u32>(select(0i, _e6602, (_e6602 > 0i)))];
let _e6610 = -((_e6608 * _e5820.member_21));
let _e6612 = select(-87f, _e6610, (_e6610 > -87f));
let _e6614 = select(88f, _e6612, (_e6612 < 88f));
let _e6616 = ((_e6614 * 1.442695f) + 0.5f);
let _e6618 = select(-127f, _e6616, (_e6616 > -127f));
let _e6620 = select(128f, _e6618, (_e6618 < 128f));
let _e6627 = select(0i, select(select(i32(_e6620), i32(-2147483648), (_e6620 < -2147483600f)), 2147483647i, (_e6620 > 2147483500f)), (_e6620 == _e6620));
let _e6631 = (_e6627 - select(0i, 1i, (_e6620 < f32(_e6627))));
let _e6632 = f32(_e6631);
let _e6636 = ((_e6614 - (_e6632 * 0.6933594f)) - (_e6632 * -2.1219444e-4f));
phi_7731_ = type_20(_e6482.member, _e6482.member_1, vec3<f32>((_e5820.member_2.x * ((1f + (_e6522 * (1f + (_e6522 * (0.5f + (_e6522 * (0.16666667f + (_e6522 * (0.041666668f + (_e6522 * (0.008333334f + (_e6522 * (0.001388889f + (_e6522 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6517 + 127i)) << bitcast<u32>(23i))))), (_e5820.member_2.y * ((1f + (_e6579 * (1f + (_e6579 * (0.5f + (_e6579 * (0.16666667f + (_e6579 * (0.041666668f + (_e6579 * (0.008333334f + (_e6579 * (0.001388889f + (_e6579 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6574 + 127i)) << bitcast<u32>(23i))))), (_e5820.member_2.z * ((1f + (_e6636 * (1f + (_e6636 * (0.5f + (_e6636 * (0.16666667f + (_e6636 * (0.041666668f + (_e6636 * (0.008333334f + (_e6636 * (0.001388889f + (_e6636 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6631 + 127i)) << bitcast<u32>(23i)))))), _e6482.member_3, _e6482.member_4, _e6482.member_5, _e6482.member_6, _e6482.member_7, _e6482.member_8, _e6482.member_9, _e6482.member_10, _e6482.member_11, _e6482.member_12, _e6482.member_13, _e6482.member_14, _e6482.member_15, _e6482.member_16, _e6482.member_17, _e6482.member_18, _e6482.member_19, _e6482.member_20, _e6482.member_21);
} else {
phi_7731_ = _e6457;
}
let _e6690 = phi_7731_;
phi_8325_ = type_20(_e6690.member, _e6690.member_1, _e6690.member_2, _e6690.member_3, _e6690.member_4, _e6690.member_5, 3f, _e6690.member_7, _e6690.member_8, _e6690.member_9, _e6690.member_10, _e6690.member_11, _e6690.member_12, _e6690.member_13, _e6690.member_14, _e6690.member_15, _e6690.member_16, _e6690.member_17, _e6690.member_18, _e6690.member_19, _e6690.member_20, _e6690.member_21);
} else {
if _e5822 {
let _e5862 = type_20(vec3<f32>((_e5820.member.x + (_e5820.member_1.x * _e1260)), (_e5820.member.y + (_e5820.member_1.y * _e1260)), (_e5820.member.z + (_e5820.member_1.z * _e1260))), _e5820.member_1, _e5820.member_2, _e5820.member_3, _e5820.member_4, _e5820.member_5, _e5820.member_6, _e5820.member_7, _e5820.member_8, _e5820.member_9, _e5820.member_10, _e5820.member_11, _e5820.member_12, _e5820.member_13, _e5820.member_14, _e5820.member_15, _e5820.member_16, _e5820.member_17, _e5820.member_18, _e5820.member_19, _e5820.member_20, _e5820.member_21);
let _e5886 = type_20(_e5862.member, _e5862.member_1, _e5862.member_2, _e5862.member_3, _e5862.member_4, (_e5820.member_5 + _e1260), _e5862.member_6, _e5862.member_7, _e5862.member_8, _e5862.member_9, _e5862.member_10, _e5862.member_11, _e5862.member_12, _e5862.member_13, _e5862.member_14, _e5862.member_15, _e5862.member_16, _e5862.member_17, _e5862.member_18, _e5862.member_19, _e5862.member_20, _e5862.member_21);
let _e5910 = type_20(_e5886.member, _e5886.member_1, _e5886.member_2, _e5886.member_3, _e5886.member_4, _e5886.member_5, _e5886.member_6, _e5886.member_7, _e5886.member_8, _e5886.member_9, _e5886.member_10, _e5886.member_11, _e5886.member_12, _e5886.member_13, _e5886.member_14, _e5886.member_15, _e5886.member_16, _e5886.member_17, _e5886.member_18, _e5886.member_19, _e5886.member_20, (_e5820.member_21 - _e1260));
let _e5937 = type_20(_e5910.member, _e5910.member_1, _e5910.member_2, _e5910.member_3, _e5910.member_4, _e5910.member_5, _e5910.member_6, _e5910.member_7, _e5910.member_8, _e5910.member_9, (_e5820.member_10 + select(0f, _e1260, (_e5820.member_8 == 0f))), _e5910.member_11, _e5910.member_12, _e5910.member_13, _e5910.member_14, _e5910.member_15, _e5910.member_16, _e5910.member_17, _e5910.member_18, _e5910.member_19, _e5910.member_20, _e5910.member_21);
if (_e1049.member_7 != 16i) {
let _e5962 = type_20(_e5937.member, _e5937.member_1, _e5937.member_2, _e5937.member_3, _e5937.member_4, _e5937.member_5, _e5937.member_6, _e5937.member_7, _e5937.member_8, (_e5820.member_9 + _e1260), _e5937.member_10, _e5937.member_11, _e5937.member_12, _e5937.member_13, _e5937.member_14, _e5937.member_15, _e5937.member_16, _e5937.member_17, _e5937.member_18, _e5937.member_19, _e5937.member_20, _e5937.member_21);
let _e5963 = (_e1049.member_7 * 4i);
let _e5964 = (_e5963 + 1i);
let _e5966 = (bitcast<i32>(_e112) - 1i);
let _e5968 = select(_e5966, _e5964, (_e5964 < _e5966));
let _e5974 = global_2.member[bitcast<u32>(select(0i, _e5968, (_e5968 > 0i)))];
let _e5976 = -((_e5974 * _e1260));
let _e5978 = select(-87f, _e5976, (_e5976 > -87f));
let _e5980 = select(88f, _e5978, (_e5978 < 88f));
let _e5982 = ((_e5980 * 1.442695f) + 0.5f);
let _e5984 = select(-127f, _e5982, (_e5982 > -127f));
let _e5986 = select(128f, _e5984, (_e5984 < 128f));
let _e5993 = select(0i, select(select(i32(_e5986), i32(-2147483648), (_e5986 < -2147483600f)), 2147483647i, (_e5986 > 2147483500f)), (_e5986 == _e5986));
let _e5997 = (_e5993 - select(0i, 1i, (_e5986 < f32(_e5993))));
let _e5998 = f32(_e5997);
let _e6002 = ((_e5980 - (_e5998 * 0.6933594f)) - (_e5998 * -2.1219444e-4f));
let _e6023 = (_e5963 + 2i);
let _e6025 = select(_e5966, _e6023, (_e6023 < _e5966));
let _e6031 = global_2.member[bitcast<u32>(select(0i, _e6025, (_e6025 > 0i)))];
let _e6033 = -((_e6031 * _e1260));
let _e6035 = select(-87f, _e6033, (_e6033 > -87f));
let _e6037 = select(88f, _e6035, (_e6035 < 88f));
let _e6039 = ((_e6037 * 1.442695f) + 0.5f);
let _e6041 = select(-127f, _e6039, (_e6039 > -127f));
let _e6043 = select(128f, _e6041, (_e6041 < 128f));
let _e6050 = select(0i, select(select(i32(_e6043), i32(-2147483648), (_e6043 < -2147483600f)), 2147483647i, (_e6043 > 2147483500f)), (_e6043 == _e6043));
let _e6054 = (_e6050 - select(0i, 1i, (_e6043 < f32(_e6050))));
let _e6055 = f32(_e6054);
let _e6059 = ((_e6037 - (_e6055 * 0.6933594f)) - (_e6055 * -2.1219444e-4f));
let _e6080 = (_e5963 + 3i);
let _e6082 = select(_e5966, _e6080, (_e6080 < _e5966));
let _e6088 = global_2.member[bitcast<u32>(select(0i, _e6082, (_e6082 > 0i)))];
let _e6090 = -((_e6088 * _e1260));
let _e6092 = select(-87f, _e6090, (_e6090 > -87f));
let _e6094 = select(88f, _e6092, (_e6092 < 88f));
let _e6096 = ((_e6094 * 1.442695f) + 0.5f);
let _e6098 = select(-127f, _e6096, (_e6096 > -127f));
let _e6100 = select(128f, _e6098, (_e6098 < 128f));
let _e6107 = select(0i, select(select(i32(_e6100), i32(-2147483648), (_e6100 < -2147483600f)), 2147483647i, (_e6100 > 2147483500f)), (_e6100 == _e6100));
let _e6111 = (_e6107 - select(0i, 1i, (_e6100 < f32(_e6107))));
let _e6112 = f32(_e6111);
let _e6116 = ((_e6094 - (_e6112 * 0.6933594f)) - (_e6112 * -2.1219444e-4f));
phi_8020_ = type_20(_e5962.member, _e5962.member_1, vec3<f32>((_e5820.member_2.x * ((1f + (_e6002 * (1f + (_e6002 * (0.5f + (_e6002 * (0.16666667f + (_e6002 * (0.041666668f + (_e6002 * (0.008333334f + (_e6002 * (0.001388889f + (_e6002 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5997 + 127i)) << bitcast<u32>(23i))))), (_e5820.member_2.y * ((1f + (_e6059 * (1f + (_e6059 * (0.5f + (_e6059 * (0.16666667f + (_e6059 * (0.041666668f + (_e6059 * (0.008333334f + (_e6059 * (0.001388889f + (_e6059 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6054 + 127i)) << bitcast<u32>(23i))))), (_e5820.member_2.z * ((1f + (_e6116 * (1f + (_e6116 * (0.5f + (_e6116 * (0.16666667f + (_e6116 * (0.041666668f + (_e6116 * (0.008333334f + (_e6116 * (0.001388889f + (_e6116 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6111 + 127i)) << bitcast<u32>(23i)))))), _e5962.member_3, _e5962.member_4, _e5962.member_5, _e5962.member_6, _e5962.member_7, _e5962.member_8, _e5962.member_9, _e5962.member_10, _e5962.member_11, _e5962.member_12, _e5962.member_13, _e5962.member_14, _e5962.member_15, _e5962.member_16, _e5962.member_17, _e5962.member_18, _e5962.member_19, _e5962.member_20, _e5962.member_21);
} else {
phi_8020_ = _e5937;
}
let _e6170 = phi_8020_;
let _e6173 = local_21;
if (((_e1110 <= 0f) && (_e6173 == 16i)) && (_e1049.member_7 == 16i)) {
if (_e6170.member_20 == -1i) {
phi_8322_ = type_20(_e6170.member, _e6170.member_1, _e6170.member_2, _e6170.member_3, _e6170.member_4, _e6170.member_5, 1f, _e6170.member_7, _e6170.member_8, _e6170.member_9, _e6170.member_10, _e6170.member_11, _e6170.member_12, _e6170.member_13, _e6170.member_14, _e6170.member_15, _e6170.member_16, _e6170.member_17, _e6170.member_18, _e6170.member_19, _e6170.member_20, _e6170.member_21);
} else {
let _e6219 = type_20(vec3<f32>((_e6170.member.x + (_e6170.member_1.x * _e6170.member_21)), (_e6170.member.y + (_e6170.member_1.y * _e6170.member_21)), (_e6170.member.z + (_e6170.member_1.z * _e6170.member_21))), _e6170.member_1, _e6170.member_2, _e6170.member_3, _e6170.member_4, _e6170.member_5, _e6170.member_6, _e6170.member_7, _e6170.member_8, _e6170.member_9, _e6170.member_10, _e6170.member_11, _e6170.member_12, _e6170.member_13, _e6170.member_14, _e6170.member_15, _e6170.member_16, _e6170.member_17, _e6170.member_18, _e6170.member_19, _e6170.member_20, _e6170.member_21);
let _e6243 = type_20(_e6219.member, _e6219.member_1, _e6219.member_2, _e6219.member_3, _e6219.member_4, (_e6170.member_5 + _e6170.member_21), _e6219.member_6, _e6219.member_7, _e6219.member_8, _e6219.member_9, _e6219.member_10, _e6219.member_11, _e6219.member_12, _e6219.member_13, _e6219.member_14, _e6219.member_15, _e6219.member_16, _e6219.member_17, _e6219.member_18, _e6219.member_19, _e6219.member_20, _e6219.member_21);
let _e6266 = type_20(_e6243.member, _e6243.member_1, _e6243.member_2, _e6243.member_3, _e6243.member_4, _e6243.member_5, _e6243.member_6, _e6243.member_7, _e6243.member_8, _e6243.member_9, _e6243.member_10, _e6243.member_11, _e6243.member_12, _e6243.member_13, _e6243.member_14, _e6243.member_15, _e6243.member_16, _e6243.member_17, _e6243.member_18, _e6243.member_19, _e6243.member_20, (_e6170.member_21 - _e6170.member_21));
let _e6293 = type_20(_e6266.member, _e6266.member_1, _e6266.member_2, _e6266.member_3, _e6266.member_4, _e6266.member_5, _e6266.member_6, _e6266.member_7, _e6266.member_8, _e6266.member_9, (_e6170.member_10 + select(0f, _e6170.member_21, (_e6170.member_8 == 0f))), _e6266.member_11, _e6266.member_12, _e6266.member_13, _e6266.member_14, _e6266.member_15, _e6266.member_16, _e6266.member_17, _e6266.member_18, _e6266.member_19, _e6266.member_20, _e6266.member_21);
phi_8322_ = type_20(_e6293.member, _e6293.member_1, _e6293.member_2, _e6293.member_3, _e6293.member_4, _e6293.member_5, 3f, _e6293.member_7, _e6293.member_8, _e6293.member_9, _e6293.member_10, _e6293.member_11, _e6293.member_12, _e6293.member_13, _e6293.member_14, _e6293.member_15, _e6293.member_16, _e6293.member_17, _e6293.member_18, _e6293.member_19, _e6293.member_20, _e6293.member_21);
}
let _e6339 = phi_8322_;
phi_8323_ = _e6339;
} else {
phi_8323_ = _e6170;
}
let _e6341 = phi_8323_;
phi_8324_ = _e6341;
} else {
phi_8324_ = _e5820;
}
let _e6343 = phi_8324_;
phi_8325_ = _e6343;
}
let _e6714 = phi_8325_;
phi_1564_ = _e6714;
phi_1567_ = (_e1051 + 1i);
} else {
phi_1564_ = type_20();
phi_1567_ = i32();
}
let _e6716 = phi_1564_;
let _e6718 = phi_1567_;
continue;
continuing {
phi_1563_ = _e6716;
phi_1566_ = _e6718;
break if !(_e1055);
}
}
let _e6721 = local_22;
let _e6725 = local_23;
let _e6729 = local_24;
let _e6733 = local_25;
let _e6737 = local_26;
let _e6741 = local_27;
let _e6745 = local_28;
let _e6749 = local_29;
let _e6753 = local_30;
let _e6757 = local_31;
let _e6761 = local_32;
let _e6765 = local_33;
let _e6769 = local_34;
let _e6773 = local_35;
let _e6777 = local_36;
let _e6781 = local_37;
let _e6784 = local_38;
let _e6788 = local_39;
let _e6791 = local_40;
let _e6794 = local_41;
let _e6797 = local_42;
let _e6800 = local_43;
let _e6804 = local_44;
let _e6808 = local_45;
let _e6812 = local_46;
let _e6816 = local_47;
let _e6820 = local_48;
let _e6824 = local_49;
let _e6828 = local_50;
let _e6832 = local_51;
let _e6836 = local_52;
let _e6840 = local_53;
let _e6844 = local_54;
let _e6848 = local_55;
let _e6852 = local_56;
let _e6856 = local_57;
let _e6860 = local_58;
let _e6864 = local_59;
let _e6868 = local_60;
let _e6872 = local_61;
let _e6876 = local_62;
let _e6880 = local_63;
let _e6884 = local_64;
global_3.member[_e128] = _e6721.member.x;
global_3.member[_e140] = _e6725.member.y;
global_3.member[_e151] = _e6729.member.z;
global_3.member[_e162] = _e6733.member_1.x;
global_3.member[_e173] = _e6737.member_1.y;
global_3.member[_e184] = _e6741.member_1.z;
global_3.member[_e195] = _e6745.member_2.x;
global_3.member[_e206] = _e6749.member_2.y;
global_3.member[_e217] = _e6753.member_2.z;
global_3.member[_e228] = _e6757.member_3.x;
global_3.member[_e239] = _e6761.member_3.y;
global_3.member[_e250] = _e6765.member_3.z;
global_3.member[_e261] = _e6769.member_4.x;
global_3.member[_e272] = _e6773.member_4.y;
global_3.member[_e283] = _e6777.member_4.z;
global_3.member[_e294] = _e6781.member_5;
let _e6921 = local_65;
global_3.member[_e305] = _e6921;
global_3.member[_e316] = f32(_e6784.member_7);
global_3.member[_e327] = _e6788.member_8;
global_3.member[_e338] = _e6791.member_9;
global_3.member[_e349] = _e6794.member_10;
global_3.member[_e360] = _e6797.member_11;
global_3.member[_e371] = _e6800.member_12.x;
global_3.member[_e382] = _e6804.member_12.y;
global_3.member[_e393] = _e6808.member_12.z;
global_3.member[_e404] = _e6812.member_13.x;
global_3.member[_e415] = _e6816.member_13.y;
global_3.member[_e426] = _e6820.member_13.z;
global_3.member[_e437] = _e6824.member_14.x;
global_3.member[_e448] = _e6828.member_14.y;
global_3.member[_e459] = _e6832.member_14.z;
global_3.member[_e470] = _e6836.member_15.x;
global_3.member[_e481] = _e6840.member_15.y;
global_3.member[_e492] = _e6844.member_15.z;
global_3.member[_e503] = _e6848.member_16.x;
global_3.member[_e514] = _e6852.member_16.y;
global_3.member[_e525] = _e6856.member_16.z;
global_3.member[_e536] = _e6860.member_17.x;
global_3.member[_e547] = _e6864.member_17.y;
global_3.member[_e558] = _e6868.member_17.z;
global_3.member[_e569] = f32(_e6872.member_18);
global_3.member[_e580] = f32(_e6876.member_19);
global_3.member[_e591] = f32(_e6880.member_20);
global_3.member[_e602] = _e6884.member_21;
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
