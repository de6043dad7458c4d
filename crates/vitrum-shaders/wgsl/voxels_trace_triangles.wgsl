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
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
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
member_12: i32,
member_13: i32,
member_14: f32,
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
var phi_648_: u32;
var phi_901_: f32;
var phi_947_: i32;
var phi_949_: type_21;
var phi_952_: type_20;
var phi_954_: i32;
var phi_956_: i32;
var phi_2045_: i32;
var phi_2048_: i32;
var phi_2046_: i32;
var phi_2049_: i32;
var phi_2079_: i32;
var phi_2082_: i32;
var phi_2080_: i32;
var phi_2083_: i32;
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_3715_: type_20;
var phi_4215_: type_20;
var phi_4268_: type_20;
var phi_4282_: type_20;
var local_7: i32;
var local_8: i32;
var phi_4726_: type_20;
var phi_4727_: type_20;
var phi_4707_: type_20;
var phi_4728_: type_20;
var local_9: i32;
var local_10: i32;
var phi_2433_: type_20;
var phi_4734_: type_21;
var phi_4735_: type_20;
var phi_4736_: i32;
var phi_4737_: type_21;
var phi_4738_: type_20;
var phi_4739_: i32;
var phi_4741_: type_21;
var phi_4742_: type_20;
var phi_4743_: i32;
var phi_4745_: bool;
var phi_4756_: type_21;
var phi_4757_: type_20;
var phi_4758_: i32;
var phi_4760_: bool;
var phi_4761_: bool;
var phi_5058_: type_20;
var phi_5059_: type_20;
var local_11: i32;
var local_12: i32;
var phi_5326_: type_20;
var phi_5614_: type_21;
var phi_5615_: type_20;
var phi_5621_: type_21;
var phi_5622_: type_20;
var phi_1263_: i32;
var phi_1877_: i32;
var phi_2016_: type_21;
var phi_2008_: bool;
var phi_2009_: bool;
var phi_2017_: type_21;
var phi_2018_: bool;
var phi_2025_: type_21;
var phi_2026_: type_20;
var phi_2027_: type_21;
var phi_2028_: type_20;
var phi_2030_: type_21;
var phi_2031_: type_20;
var phi_2032_: bool;
var phi_2036_: type_21;
var phi_2037_: type_20;
var phi_2038_: bool;
var phi_2042_: type_21;
var phi_2043_: type_20;
var phi_5624_: type_21;
var phi_5625_: type_20;
var phi_5626_: i32;
var phi_950_: type_21;
var phi_953_: type_20;
var phi_955_: i32;
var phi_957_: i32;
var local_13: i32;
var local_14: i32;
var phi_5632_: i32;
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
var local_38: f32;
let _e97 = global;
let _e101 = arrayLength((&global_3.member));
let _e103 = arrayLength((&global_4.member));
let _e110 = global_1.member.member;
if (_e97.x < _e110.member) {
if (_e97.y < _e110.member_1) {
let _e117 = (_e110.member * _e110.member_1);
let _e119 = ((_e97.y * _e110.member) + _e97.x);
let _e120 = bitcast<i32>(_e119);
let _e122 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e124 = select(_e122, _e120, (_e120 < _e122));
let _e130 = global_5.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e117 + _e119);
let _e132 = bitcast<i32>(_e131);
let _e134 = select(_e122, _e132, (_e132 < _e122));
let _e140 = global_5.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e142 = ((2u * _e117) + _e119);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e122, _e143, (_e143 < _e122));
let _e151 = global_5.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((3u * _e117) + _e119);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e122, _e154, (_e154 < _e122));
let _e162 = global_5.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((4u * _e117) + _e119);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e122, _e165, (_e165 < _e122));
let _e173 = global_5.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((5u * _e117) + _e119);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e122, _e176, (_e176 < _e122));
let _e184 = global_5.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((6u * _e117) + _e119);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e122, _e187, (_e187 < _e122));
let _e195 = global_5.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((7u * _e117) + _e119);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e122, _e198, (_e198 < _e122));
let _e206 = global_5.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((8u * _e117) + _e119);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e122, _e209, (_e209 < _e122));
let _e217 = global_5.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((9u * _e117) + _e119);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e122, _e220, (_e220 < _e122));
let _e228 = global_5.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((10u * _e117) + _e119);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e122, _e231, (_e231 < _e122));
let _e239 = global_5.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((11u * _e117) + _e119);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e122, _e242, (_e242 < _e122));
let _e250 = global_5.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((12u * _e117) + _e119);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e122, _e253, (_e253 < _e122));
let _e261 = global_5.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((13u * _e117) + _e119);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e122, _e264, (_e264 < _e122));
let _e272 = global_5.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((14u * _e117) + _e119);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e122, _e275, (_e275 < _e122));
let _e283 = global_5.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((15u * _e117) + _e119);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e122, _e286, (_e286 < _e122));
let _e294 = global_5.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((16u * _e117) + _e119);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e122, _e297, (_e297 < _e122));
let _e305 = global_5.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((17u * _e117) + _e119);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e122, _e308, (_e308 < _e122));
let _e316 = global_5.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((18u * _e117) + _e119);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e122, _e319, (_e319 < _e122));
let _e327 = global_5.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((19u * _e117) + _e119);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e122, _e330, (_e330 < _e122));
let _e338 = global_5.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((20u * _e117) + _e119);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e122, _e341, (_e341 < _e122));
let _e349 = global_5.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e351 = ((21u * _e117) + _e119);
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e122, _e352, (_e352 < _e122));
let _e360 = global_5.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e362 = ((22u * _e117) + _e119);
let _e363 = bitcast<i32>(_e362);
let _e365 = select(_e122, _e363, (_e363 < _e122));
let _e371 = global_5.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e373 = ((23u * _e117) + _e119);
let _e374 = bitcast<i32>(_e373);
let _e376 = select(_e122, _e374, (_e374 < _e122));
let _e382 = global_5.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e384 = ((24u * _e117) + _e119);
let _e385 = bitcast<i32>(_e384);
let _e387 = select(_e122, _e385, (_e385 < _e122));
let _e393 = global_5.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
if (_e305 == 0f) {
phi_648_ = 3u;
} else {
phi_648_ = select(0u, 1u, (_e305 == 4f));
}
let _e398 = phi_648_;
if (_e398 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e407 = atomicLoad((&global_6.member[0u]));
if (_e407 == 0u) {
atomicStore((&global_6.member[0u]), ((_e110.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e110.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e398 > 1u) {
let _e426 = select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316));
let _e440 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < -2147483600f)), 2147483647i, (_e382 > 2147483500f)), (_e382 == _e382));
if (_e440 >= 0i) {
let _e443 = (_e440 * 19i);
let _e445 = (bitcast<i32>(_e101) - 1i);
let _e447 = select(_e445, _e443, (_e443 < _e445));
let _e453 = global_3.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e454 = (_e443 + 1i);
let _e456 = select(_e445, _e454, (_e454 < _e445));
let _e462 = global_3.member[bitcast<u32>(select(0i, _e456, (_e456 > 0i)))];
let _e463 = (_e443 + 2i);
let _e465 = select(_e445, _e463, (_e463 < _e445));
let _e471 = global_3.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e472 = (_e443 + 3i);
let _e474 = select(_e445, _e472, (_e472 < _e445));
let _e480 = global_3.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e481 = (_e443 + 4i);
let _e483 = select(_e445, _e481, (_e481 < _e445));
let _e489 = global_3.member[bitcast<u32>(select(0i, _e483, (_e483 > 0i)))];
let _e490 = (_e443 + 5i);
let _e492 = select(_e445, _e490, (_e490 < _e445));
let _e498 = global_3.member[bitcast<u32>(select(0i, _e492, (_e492 > 0i)))];
let _e499 = (_e480 - _e453);
let _e500 = (_e489 - _e462);
let _e501 = (_e498 - _e471);
let _e502 = (_e443 + 6i);
let _e504 = select(_e445, _e502, (_e502 < _e445));
let _e510 = global_3.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e511 = (_e443 + 7i);
let _e513 = select(_e445, _e511, (_e511 < _e445));
let _e519 = global_3.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e520 = (_e443 + 8i);
let _e522 = select(_e445, _e520, (_e520 < _e445));
let _e528 = global_3.member[bitcast<u32>(select(0i, _e522, (_e522 > 0i)))];
let _e529 = (_e510 - _e453);
let _e530 = (_e519 - _e462);
let _e531 = (_e528 - _e471);
let _e534 = ((_e500 * _e531) - (_e501 * _e530));
let _e537 = ((_e501 * _e529) - (_e499 * _e531));
let _e540 = ((_e499 * _e530) - (_e500 * _e529));
let _e545 = (((_e534 * _e534) + (_e537 * _e537)) + (_e540 * _e540));
let _e548 = sqrt(select(0f, _e545, (_e545 > 0f)));
let _e551 = (1f / select(1e-20f, _e548, (_e548 > 1e-20f)));
phi_901_ = (((_e162 * (_e534 * _e551)) + (_e173 * (_e537 * _e551))) + (_e184 * (_e540 * _e551)));
} else {
phi_901_ = 1f;
}
let _e561 = phi_901_;
let _e578 = bitcast<f32>((bitcast<u32>(_e561) & 2147483647u));
let _e582 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e426 == 16i) {
phi_947_ = 0i;
} else {
phi_947_ = -(_e426);
}
let _e587 = phi_947_;
phi_949_ = type_21(select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < -2147483600f)), 2147483647i, (_e261 > 2147483500f)), (_e261 == _e261)), select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < -2147483600f)), 2147483647i, (_e272 > 2147483500f)), (_e272 == _e272)), _e283, _e294, select(1e-3f, _e578, (_e578 > 1e-3f)));
phi_952_ = type_20(vec3<f32>(_e130, _e140, _e151), vec3<f32>(_e162, _e173, _e184), vec3<f32>(_e195, _e206, _e217), vec3<f32>(_e228, _e239, _e250), vec3<f32>(_e261, _e272, _e283), _e294, _e305, _e426, _e327, _e338, _e349, _e360, select(0i, select(select(i32(_e371), i32(-2147483648), (_e371 < -2147483600f)), 2147483647i, (_e371 > 2147483500f)), (_e371 == _e371)), _e440, _e393);
phi_954_ = 0i;
phi_956_ = _e587;
loop {
let _e589 = phi_949_;
let _e591 = phi_952_;
let _e593 = phi_954_;
let _e595 = phi_956_;
local_13 = _e595;
local_14 = _e595;
local_15 = _e589;
local_16 = _e589;
local_17 = _e589;
local_18 = _e589;
local_19 = _e591;
local_20 = _e591;
local_21 = _e591;
local_22 = _e591;
local_23 = _e591;
local_24 = _e591;
local_25 = _e591;
local_26 = _e591;
local_27 = _e591;
local_28 = _e591;
local_29 = _e591;
local_30 = _e591;
local_31 = _e591;
local_32 = _e591;
local_33 = _e591;
local_34 = _e591;
local_35 = _e591;
local_36 = _e591;
local_37 = _e591;
let _e599 = ((_e593 < 1024i) && (_e591.member_6 == 0f));
local_38 = _e591.member_6;
if _e599 {
if (_e591.member_12 < (_e582 / 8i)) {
let _e2819 = global_1.member.member_13;
let _e2821 = (_e591.member_13 >= 0i);
let _e2826 = (_e591.member_14 + select(0f, (_e2819 / _e589.member_4), _e2821));
let _e2834 = (_e591.member_12 * 8i);
let _e2842 = (1f / select(_e591.member_1.x, select(1e-12f, -1e-12f, (_e591.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e591.member_1.x) & 2147483647u)) < 1e-12f)));
let _e2850 = (1f / select(_e591.member_1.y, select(1e-12f, -1e-12f, (_e591.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e591.member_1.y) & 2147483647u)) < 1e-12f)));
let _e2858 = (1f / select(_e591.member_1.z, select(1e-12f, -1e-12f, (_e591.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e591.member_1.z) & 2147483647u)) < 1e-12f)));
let _e2860 = (_e582 - 1i);
let _e2862 = select(_e2860, _e2834, (_e2834 < _e2860));
let _e2868 = global_2.member[bitcast<u32>(select(0i, _e2862, (_e2862 > 0i)))];
let _e2869 = (_e2834 + 1i);
let _e2871 = select(_e2860, _e2869, (_e2869 < _e2860));
let _e2877 = global_2.member[bitcast<u32>(select(0i, _e2871, (_e2871 > 0i)))];
let _e2878 = (_e2834 + 2i);
let _e2880 = select(_e2860, _e2878, (_e2878 < _e2860));
let _e2886 = global_2.member[bitcast<u32>(select(0i, _e2880, (_e2880 > 0i)))];
let _e2887 = (_e2834 + 3i);
let _e2889 = select(_e2860, _e2887, (_e2887 < _e2860));
let _e2895 = global_2.member[bitcast<u32>(select(0i, _e2889, (_e2889 > 0i)))];
let _e2896 = (_e2834 + 4i);
let _e2898 = select(_e2860, _e2896, (_e2896 < _e2860));
let _e2904 = global_2.member[bitcast<u32>(select(0i, _e2898, (_e2898 > 0i)))];
let _e2905 = (_e2834 + 5i);
let _e2907 = select(_e2860, _e2905, (_e2905 < _e2860));
let _e2913 = global_2.member[bitcast<u32>(select(0i, _e2907, (_e2907 > 0i)))];
let _e2916 = ((_e2868 - _e591.member.x) * _e2842);
let _e2918 = ((_e2895 - _e591.member.x) * _e2842);
let _e2921 = ((_e2877 - _e591.member.y) * _e2850);
let _e2923 = ((_e2904 - _e591.member.y) * _e2850);
let _e2926 = ((_e2886 - _e591.member.z) * _e2858);
let _e2928 = ((_e2913 - _e591.member.z) * _e2858);
let _e2930 = select(_e2918, _e2916, (_e2916 < _e2918));
let _e2932 = select(_e2923, _e2921, (_e2921 < _e2923));
let _e2934 = select(_e2932, _e2930, (_e2930 > _e2932));
let _e2936 = select(_e2928, _e2926, (_e2926 < _e2928));
let _e2940 = select(_e2918, _e2916, (_e2916 > _e2918));
let _e2942 = select(_e2923, _e2921, (_e2921 > _e2923));
let _e2944 = select(_e2942, _e2940, (_e2940 < _e2942));
let _e2946 = select(_e2928, _e2926, (_e2926 > _e2928));
let _e2948 = select(_e2946, _e2944, (_e2944 < _e2946));
let _e2953 = ((select(_e2936, _e2934, (_e2934 > _e2936)) <= select(_e2826, _e2948, (_e2948 < _e2826))) && (_e2948 >= _e589.member_2));
let _e2954 = (_e2834 + 6i);
let _e2956 = select(_e2860, _e2954, (_e2954 < _e2860));
let _e2962 = global_2.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
if _e2953 {
phi_1263_ = (_e591.member_12 + 1i);
} else {
let _e2970 = (_e2834 + 7i);
let _e2972 = select(_e2860, _e2970, (_e2970 < _e2860));
let _e2978 = global_2.member[bitcast<u32>(select(0i, _e2972, (_e2972 > 0i)))];
phi_1263_ = select(0i, select(select(i32(_e2978), i32(-2147483648), (_e2978 < -2147483600f)), 2147483647i, (_e2978 > 2147483500f)), (_e2978 == _e2978));
}
let _e2988 = phi_1263_;
let _e3003 = type_20(_e591.member, _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, _e591.member_6, _e591.member_7, _e591.member_8, _e591.member_9, _e591.member_10, _e591.member_11, _e2988, _e591.member_13, _e591.member_14);
let _e3004 = select(-1i, select(0i, select(select(i32(_e2962), i32(-2147483648), (_e2962 < -2147483600f)), 2147483647i, (_e2962 > 2147483500f)), (_e2962 == _e2962)), _e2953);
if (_e3004 < 0i) {
phi_2036_ = type_21();
phi_2037_ = type_20();
phi_2038_ = true;
} else {
let _e3010 = bitcast<f32>((bitcast<u32>(_e591.member_1.x) & 2147483647u));
let _e3014 = bitcast<f32>((bitcast<u32>(_e591.member_1.y) & 2147483647u));
let _e3018 = bitcast<f32>((bitcast<u32>(_e591.member_1.z) & 2147483647u));
let _e3021 = ((_e3010 >= _e3014) && (_e3010 >= _e3018));
let _e3024 = (!(_e3021) && (_e3014 >= _e3018));
let _e3031 = (1f / select(select(_e591.member_1.z, _e591.member_1.y, _e3024), _e591.member_1.x, _e3021));
let _e3032 = (select(select(_e591.member_1.x, _e591.member_1.z, _e3024), _e591.member_1.y, _e3021) * _e3031);
let _e3033 = (select(select(_e591.member_1.y, _e591.member_1.x, _e3024), _e591.member_1.z, _e3021) * _e3031);
let _e3034 = (_e3004 * 19i);
let _e3036 = (bitcast<i32>(_e101) - 1i);
let _e3038 = select(_e3036, _e3034, (_e3034 < _e3036));
let _e3044 = global_3.member[bitcast<u32>(select(0i, _e3038, (_e3038 > 0i)))];
let _e3045 = (_e3034 + 1i);
let _e3047 = select(_e3036, _e3045, (_e3045 < _e3036));
let _e3053 = global_3.member[bitcast<u32>(select(0i, _e3047, (_e3047 > 0i)))];
let _e3054 = (_e3034 + 2i);
let _e3056 = select(_e3036, _e3054, (_e3054 < _e3036));
let _e3062 = global_3.member[bitcast<u32>(select(0i, _e3056, (_e3056 > 0i)))];
let _e3063 = (_e3044 - _e591.member.x);
let _e3064 = (_e3053 - _e591.member.y);
let _e3065 = (_e3062 - _e591.member.z);
let _e3071 = select(select(_e3065, _e3064, _e3024), _e3063, _e3021);
let _e3073 = (select(select(_e3063, _e3065, _e3024), _e3064, _e3021) - (_e3032 * _e3071));
let _e3075 = (select(select(_e3064, _e3063, _e3024), _e3065, _e3021) - (_e3033 * _e3071));
let _e3077 = (_e3034 + 3i);
let _e3079 = select(_e3036, _e3077, (_e3077 < _e3036));
let _e3085 = global_3.member[bitcast<u32>(select(0i, _e3079, (_e3079 > 0i)))];
let _e3086 = (_e3034 + 4i);
let _e3088 = select(_e3036, _e3086, (_e3086 < _e3036));
let _e3094 = global_3.member[bitcast<u32>(select(0i, _e3088, (_e3088 > 0i)))];
let _e3095 = (_e3034 + 5i);
let _e3097 = select(_e3036, _e3095, (_e3095 < _e3036));
let _e3103 = global_3.member[bitcast<u32>(select(0i, _e3097, (_e3097 > 0i)))];
let _e3104 = (_e3085 - _e591.member.x);
let _e3105 = (_e3094 - _e591.member.y);
let _e3106 = (_e3103 - _e591.member.z);
let _e3112 = select(select(_e3106, _e3105, _e3024), _e3104, _e3021);
let _e3114 = (select(select(_e3104, _e3106, _e3024), _e3105, _e3021) - (_e3032 * _e3112));
let _e3116 = (select(select(_e3105, _e3104, _e3024), _e3106, _e3021) - (_e3033 * _e3112));
let _e3118 = (_e3034 + 6i);
let _e3120 = select(_e3036, _e3118, (_e3118 < _e3036));
let _e3126 = global_3.member[bitcast<u32>(select(0i, _e3120, (_e3120 > 0i)))];
let _e3127 = (_e3034 + 7i);
let _e3129 = select(_e3036, _e3127, (_e3127 < _e3036));
let _e3135 = global_3.member[bitcast<u32>(select(0i, _e3129, (_e3129 > 0i)))];
let _e3136 = (_e3034 + 8i);
let _e3138 = select(_e3036, _e3136, (_e3136 < _e3036));
let _e3144 = global_3.member[bitcast<u32>(select(0i, _e3138, (_e3138 > 0i)))];
let _e3145 = (_e3126 - _e591.member.x);
let _e3146 = (_e3135 - _e591.member.y);
let _e3147 = (_e3144 - _e591.member.z);
let _e3153 = select(select(_e3147, _e3146, _e3024), _e3145, _e3021);
let _e3155 = (select(select(_e3145, _e3147, _e3024), _e3146, _e3021) - (_e3032 * _e3153));
let _e3157 = (select(select(_e3146, _e3145, _e3024), _e3147, _e3021) - (_e3033 * _e3153));
let _e3161 = ((_e3155 * _e3116) - (_e3157 * _e3114));
let _e3164 = ((_e3073 * _e3157) - (_e3075 * _e3155));
let _e3167 = ((_e3114 * _e3075) - (_e3116 * _e3073));
let _e3169 = ((_e3161 + _e3164) + _e3167);
let _e3183 = (!(((((_e3161 < 0f) || (_e3164 < 0f)) || (_e3167 < 0f)) && (((_e3161 > 0f) || (_e3164 > 0f)) || (_e3167 > 0f)))) && (_e3169 != 0f));
let _e3191 = select(1e30f, ((((_e3161 * (_e3071 * _e3031)) + (_e3164 * (_e3112 * _e3031))) + (_e3167 * (_e3153 * _e3031))) / select(1f, _e3169, _e3183)), _e3183);
if (_e3191 >= _e2826) {
phi_2030_ = type_21();
phi_2031_ = type_20();
phi_2032_ = true;
} else {
let _e3193 = (_e3085 - _e3044);
let _e3194 = (_e3094 - _e3053);
let _e3195 = (_e3103 - _e3062);
let _e3196 = (_e3126 - _e3044);
let _e3197 = (_e3135 - _e3053);
let _e3198 = (_e3144 - _e3062);
let _e3201 = ((_e3194 * _e3198) - (_e3195 * _e3197));
let _e3204 = ((_e3195 * _e3196) - (_e3193 * _e3198));
let _e3207 = ((_e3193 * _e3197) - (_e3194 * _e3196));
let _e3212 = (((_e3201 * _e3201) + (_e3204 * _e3204)) + (_e3207 * _e3207));
let _e3215 = sqrt(select(0f, _e3212, (_e3212 > 0f)));
let _e3218 = (1f / select(1e-20f, _e3215, (_e3215 > 1e-20f)));
let _e3226 = (((_e591.member_1.x * (_e3201 * _e3218)) + (_e591.member_1.y * (_e3204 * _e3218))) + (_e591.member_1.z * (_e3207 * _e3218)));
let _e3229 = bitcast<f32>((bitcast<u32>(_e3226) & 2147483647u));
let _e3231 = select(1e-3f, _e3229, (_e3229 > 1e-3f));
let _e3232 = (_e3034 + 18i);
let _e3234 = select(_e3036, _e3232, (_e3232 < _e3036));
let _e3240 = global_3.member[bitcast<u32>(select(0i, _e3234, (_e3234 > 0i)))];
let _e3247 = select(0i, select(select(i32(_e3240), i32(-2147483648), (_e3240 < -2147483600f)), 2147483647i, (_e3240 > 2147483500f)), (_e3240 == _e3240));
let _e3248 = (_e3247 * 4i);
let _e3250 = (bitcast<i32>(_e103) - 1i);
let _e3252 = select(_e3250, _e3248, (_e3248 < _e3250));
let _e3258 = global_4.member[bitcast<u32>(select(0i, _e3252, (_e3252 > 0i)))];
let _e3261 = (select(_e3258, 1f, (_e3247 == 16i)) == 0f);
if _e3261 {
phi_1877_ = 0i;
} else {
phi_1877_ = (1i << bitcast<u32>((_e3247 & 31i)));
}
let _e3266 = phi_1877_;
let _e3267 = (_e3226 < 0f);
let _e3268 = select(_e3266, 0i, _e3267);
let _e3269 = select(0i, _e3266, _e3267);
let _e3277 = (_e3191 * _e3231);
let _e3290 = (((_e3191 > _e589.member_2) && (_e589.member_2 > 0f)) || (((_e3277 > (_e2819 * 2f)) || (((_e3261 || ((_e3269 & ~(_e595)) != 0i)) || ((_e3268 & _e595) != 0i)) && (_e3277 >= -((_e2819 * 0.5f))))) && (_e589.member_2 <= 0f)));
if _e3290 {
let _e3291 = (_e3191 < _e591.member_14);
if (_e2821 && ((bitcast<f32>((bitcast<u32>((_e3191 - _e591.member_14)) & 2147483647u)) * select(_e589.member_4, _e3231, (_e3231 > _e589.member_4))) <= _e2819)) {
let _e3324 = type_21((_e589.member | _e3269), _e589.member_1, _e589.member_2, _e589.member_3, _e589.member_4);
let _e3331 = type_21(_e3324.member, (_e589.member_1 | _e3268), _e3324.member_2, _e3324.member_3, _e3324.member_4);
let _e3341 = ((_e591.member_13 * 19i) + 18i);
let _e3343 = select(_e3036, _e3341, (_e3341 < _e3036));
let _e3349 = global_3.member[bitcast<u32>(select(0i, _e3343, (_e3343 > 0i)))];
let _e3356 = select(0i, select(select(i32(_e3349), i32(-2147483648), (_e3349 < -2147483600f)), 2147483647i, (_e3349 > 2147483500f)), (_e3349 == _e3349));
let _e3357 = (_e3356 * 4i);
let _e3359 = select(_e3250, _e3357, (_e3357 < _e3250));
let _e3365 = global_4.member[bitcast<u32>(select(0i, _e3359, (_e3359 > 0i)))];
if (_e3261 != (select(_e3365, 1f, (_e3356 == 16i)) == 0f)) {
phi_2009_ = _e3261;
} else {
if (!(_e3261) && (_e3247 != _e3356)) {
phi_2008_ = (_e3247 < _e3356);
} else {
phi_2008_ = _e3291;
}
let _e3375 = phi_2008_;
phi_2009_ = _e3375;
}
let _e3377 = phi_2009_;
phi_2017_ = type_21(_e3331.member, _e3331.member_1, _e3331.member_2, select(_e3191, _e589.member_3, (_e589.member_3 > _e3191)), _e3331.member_4);
phi_2018_ = _e3377;
} else {
if _e3291 {
let _e3305 = type_21(_e3269, _e589.member_1, _e589.member_2, _e589.member_3, _e589.member_4);
let _e3310 = type_21(_e3305.member, _e3268, _e3305.member_2, _e3305.member_3, _e3305.member_4);
phi_2016_ = type_21(_e3310.member, _e3310.member_1, _e3310.member_2, _e3191, _e3310.member_4);
} else {
phi_2016_ = _e589;
}
let _e3317 = phi_2016_;
phi_2017_ = _e3317;
phi_2018_ = _e3291;
}
let _e3379 = phi_2017_;
let _e3381 = phi_2018_;
if _e3381 {
let _e3396 = type_20(_e3003.member, _e3003.member_1, _e3003.member_2, _e3003.member_3, _e3003.member_4, _e3003.member_5, _e3003.member_6, _e3003.member_7, _e3003.member_8, _e3003.member_9, _e3003.member_10, _e3003.member_11, _e3003.member_12, _e3004, _e3003.member_14);
phi_2025_ = type_21(_e3379.member, _e3379.member_1, _e3379.member_2, _e3379.member_3, _e3231);
phi_2026_ = type_20(_e3396.member, _e3396.member_1, _e3396.member_2, _e3396.member_3, _e3396.member_4, _e3396.member_5, _e3396.member_6, _e3396.member_7, _e3396.member_8, _e3396.member_9, _e3396.member_10, _e3396.member_11, _e3396.member_12, _e3396.member_13, _e3191);
} else {
phi_2025_ = _e3379;
phi_2026_ = _e3003;
}
let _e3418 = phi_2025_;
let _e3420 = phi_2026_;
phi_2027_ = _e3418;
phi_2028_ = _e3420;
} else {
phi_2027_ = type_21();
phi_2028_ = type_20();
}
let _e3422 = phi_2027_;
let _e3424 = phi_2028_;
phi_2030_ = _e3422;
phi_2031_ = _e3424;
phi_2032_ = select(true, false, _e3290);
}
let _e3427 = phi_2030_;
let _e3429 = phi_2031_;
let _e3431 = phi_2032_;
phi_2036_ = _e3427;
phi_2037_ = _e3429;
phi_2038_ = _e3431;
}
let _e3433 = phi_2036_;
let _e3435 = phi_2037_;
let _e3437 = phi_2038_;
if _e3437 {
phi_2042_ = _e589;
phi_2043_ = _e3003;
} else {
phi_2042_ = _e3433;
phi_2043_ = _e3435;
}
let _e3439 = phi_2042_;
let _e3441 = phi_2043_;
phi_5624_ = _e3439;
phi_5625_ = _e3441;
phi_5626_ = _e595;
} else {
phi_2045_ = 15i;
phi_2048_ = 16i;
loop {
let _e604 = phi_2045_;
let _e606 = phi_2048_;
local = _e606;
local_1 = _e606;
local_3 = _e606;
local_6 = _e606;
local_7 = _e606;
local_9 = _e606;
local_10 = _e606;
local_11 = _e606;
local_12 = _e606;
let _e607 = (_e604 >= 0i);
if _e607 {
phi_2046_ = (_e604 - 1i);
phi_2049_ = select(_e606, _e604, (((_e595 >> bitcast<u32>((_e604 & 31i))) & 1i) == 1i));
} else {
phi_2046_ = i32();
phi_2049_ = i32();
}
let _e616 = phi_2046_;
let _e618 = phi_2049_;
continue;
continuing {
phi_2045_ = _e616;
phi_2048_ = _e618;
break if !(_e607);
}
}
let _e621 = (_e591.member_13 >= 0i);
let _e630 = ((_e595 | (_e589.member & ~(_e589.member_1))) & ~((_e589.member_1 & ~(_e589.member))));
phi_2079_ = 15i;
phi_2082_ = 16i;
loop {
let _e632 = phi_2079_;
let _e634 = phi_2082_;
local_2 = _e634;
local_4 = _e634;
local_5 = _e634;
local_8 = _e634;
let _e635 = (_e632 >= 0i);
if _e635 {
phi_2080_ = (_e632 - 1i);
phi_2083_ = select(_e634, _e632, (((_e630 >> bitcast<u32>((_e632 & 31i))) & 1i) == 1i));
} else {
phi_2080_ = i32();
phi_2083_ = i32();
}
let _e644 = phi_2080_;
let _e646 = phi_2083_;
continue;
continuing {
phi_2079_ = _e644;
phi_2082_ = _e646;
break if !(_e635);
}
}
let _e649 = (_e591.member_13 == -1i);
let _e651 = local;
let _e652 = (_e651 == 16i);
let _e654 = (!(_e621) && (_e649 || _e652));
if _e621 {
let _e656 = (_e591.member_13 * 19i);
let _e657 = (_e656 + 18i);
let _e659 = (bitcast<i32>(_e101) - 1i);
let _e661 = select(_e659, _e657, (_e657 < _e659));
let _e667 = global_3.member[bitcast<u32>(select(0i, _e661, (_e661 > 0i)))];
let _e674 = select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < -2147483600f)), 2147483647i, (_e667 > 2147483500f)), (_e667 == _e667));
let _e675 = (_e674 * 4i);
let _e677 = (bitcast<i32>(_e103) - 1i);
let _e679 = select(_e677, _e675, (_e675 < _e677));
let _e685 = global_4.member[bitcast<u32>(select(0i, _e679, (_e679 > 0i)))];
let _e688 = (select(_e685, 1f, (_e674 == 16i)) == 0f);
if _e654 {
phi_4741_ = type_21();
phi_4742_ = type_20();
phi_4743_ = i32();
phi_4745_ = false;
} else {
if _e688 {
phi_4737_ = type_21();
phi_4738_ = type_20();
phi_4739_ = i32();
} else {
let _e690 = local_1;
let _e692 = local_2;
if (_e690 == _e692) {
let _e1960 = (_e589.member_3 - _e589.member_2);
let _e1962 = select(0f, _e1960, (_e1960 > 0f));
let _e1964 = local_9;
if (_e1964 != 16i) {
let _e1982 = type_20(_e591.member, _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, _e591.member_6, _e591.member_7, _e591.member_8, (_e591.member_9 + _e1962), _e591.member_10, _e591.member_11, _e591.member_12, _e591.member_13, _e591.member_14);
let _e1984 = local_10;
let _e1985 = (_e1984 * 4i);
let _e1986 = (_e1985 + 1i);
let _e1988 = select(_e677, _e1986, (_e1986 < _e677));
let _e1994 = global_4.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1996 = -((_e1994 * _e1962));
let _e1998 = select(-87f, _e1996, (_e1996 > -87f));
let _e2000 = select(88f, _e1998, (_e1998 < 88f));
let _e2002 = ((_e2000 * 1.442695f) + 0.5f);
let _e2004 = select(-127f, _e2002, (_e2002 > -127f));
let _e2006 = select(128f, _e2004, (_e2004 < 128f));
let _e2013 = select(0i, select(select(i32(_e2006), i32(-2147483648), (_e2006 < -2147483600f)), 2147483647i, (_e2006 > 2147483500f)), (_e2006 == _e2006));
let _e2017 = (_e2013 - select(0i, 1i, (_e2006 < f32(_e2013))));
let _e2018 = f32(_e2017);
let _e2022 = ((_e2000 - (_e2018 * 0.6933594f)) - (_e2018 * -2.1219444e-4f));
let _e2046 = (_e1985 + 2i);
let _e2048 = select(_e677, _e2046, (_e2046 < _e677));
let _e2054 = global_4.member[bitcast<u32>(select(0i, _e2048, (_e2048 > 0i)))];
let _e2056 = -((_e2054 * _e1962));
let _e2058 = select(-87f, _e2056, (_e2056 > -87f));
let _e2060 = select(88f, _e2058, (_e2058 < 88f));
let _e2062 = ((_e2060 * 1.442695f) + 0.5f);
let _e2064 = select(-127f, _e2062, (_e2062 > -127f));
let _e2066 = select(128f, _e2064, (_e2064 < 128f));
let _e2073 = select(0i, select(select(i32(_e2066), i32(-2147483648), (_e2066 < -2147483600f)), 2147483647i, (_e2066 > 2147483500f)), (_e2066 == _e2066));
let _e2077 = (_e2073 - select(0i, 1i, (_e2066 < f32(_e2073))));
let _e2078 = f32(_e2077);
let _e2082 = ((_e2060 - (_e2078 * 0.6933594f)) - (_e2078 * -2.1219444e-4f));
let _e2106 = (_e1985 + 3i);
let _e2108 = select(_e677, _e2106, (_e2106 < _e677));
let _e2114 = global_4.member[bitcast<u32>(select(0i, _e2108, (_e2108 > 0i)))];
let _e2116 = -((_e2114 * _e1962));
let _e2118 = select(-87f, _e2116, (_e2116 > -87f));
let _e2120 = select(88f, _e2118, (_e2118 < 88f));
let _e2122 = ((_e2120 * 1.442695f) + 0.5f);
let _e2124 = select(-127f, _e2122, (_e2122 > -127f));
let _e2126 = select(128f, _e2124, (_e2124 < 128f));
let _e2133 = select(0i, select(select(i32(_e2126), i32(-2147483648), (_e2126 < -2147483600f)), 2147483647i, (_e2126 > 2147483500f)), (_e2126 == _e2126));
let _e2137 = (_e2133 - select(0i, 1i, (_e2126 < f32(_e2133))));
let _e2138 = f32(_e2137);
let _e2142 = ((_e2120 - (_e2138 * 0.6933594f)) - (_e2138 * -2.1219444e-4f));
phi_2433_ = type_20(_e1982.member, _e1982.member_1, vec3<f32>((_e591.member_2.x * ((1f + (_e2022 * (1f + (_e2022 * (0.5f + (_e2022 * (0.16666667f + (_e2022 * (0.041666668f + (_e2022 * (0.008333334f + (_e2022 * (0.001388889f + (_e2022 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2017 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.y * ((1f + (_e2082 * (1f + (_e2082 * (0.5f + (_e2082 * (0.16666667f + (_e2082 * (0.041666668f + (_e2082 * (0.008333334f + (_e2082 * (0.001388889f + (_e2082 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2077 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.z * ((1f + (_e2142 * (1f + (_e2142 * (0.5f + (_e2142 * (0.16666667f + (_e2142 * (0.041666668f + (_e2142 * (0.008333334f + (_e2142 * (0.001388889f + (_e2142 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2137 + 127i)) << bitcast<u32>(23i)))))), _e1982.member_3, _e1982.member_4, _e1982.member_5, _e1982.member_6, _e1982.member_7, _e1982.member_8, _e1982.member_9, _e1982.member_10, _e1982.member_11, _e1982.member_12, _e1982.member_13, _e1982.member_14);
} else {
phi_2433_ = _e591;
}
let _e2183 = phi_2433_;
let _e2190 = type_21(0i, _e589.member_1, _e589.member_2, _e589.member_3, _e589.member_4);
let _e2195 = type_21(_e2190.member, 0i, _e2190.member_2, _e2190.member_3, _e2190.member_4);
let _e2207 = global_1.member.member_17.member.member;
let _e2221 = ((((_e2207.member.member * _e2183.member.x) + (_e2207.member.member_1 * _e2183.member.y)) + (_e2207.member.member_2 * _e2183.member.z)) + _e2207.member_1);
let _e2230 = -((((_e2207.member.member * _e2183.member_1.x) + (_e2207.member.member_1 * _e2183.member_1.y)) + (_e2207.member.member_2 * _e2183.member_1.z)));
let _e2232 = (_e2230 > 1e-9f);
let _e2236 = ((_e2221 / select(1e-9f, _e2230, _e2232)) - 0.015625f);
let _e2239 = select(1e30f, select(0f, _e2236, (_e2236 > 0f)), ((_e2221 > 0f) && _e2232));
let _e2244 = global_1.member.member_17.member_1.member;
let _e2255 = ((((_e2244.member.member * _e2183.member.x) + (_e2244.member.member_1 * _e2183.member.y)) + (_e2244.member.member_2 * _e2183.member.z)) + _e2244.member_1);
let _e2261 = -((((_e2244.member.member * _e2183.member_1.x) + (_e2244.member.member_1 * _e2183.member_1.y)) + (_e2244.member.member_2 * _e2183.member_1.z)));
let _e2263 = (_e2261 > 1e-9f);
let _e2267 = ((_e2255 / select(1e-9f, _e2261, _e2263)) - 0.015625f);
let _e2270 = select(1e30f, select(0f, _e2267, (_e2267 > 0f)), ((_e2255 > 0f) && _e2263));
let _e2274 = (_e2270 < _e2239);
let _e2292 = type_20(_e2183.member, _e2183.member_1, _e2183.member_2, _e2183.member_3, _e2183.member_4, _e2183.member_5, _e2183.member_6, _e2183.member_7, _e2183.member_8, _e2183.member_9, _e2183.member_10, _e2183.member_11, 0i, _e2183.member_13, _e2183.member_14);
let _e2307 = type_20(_e2292.member, _e2292.member_1, _e2292.member_2, _e2292.member_3, _e2292.member_4, _e2292.member_5, _e2292.member_6, _e2292.member_7, _e2292.member_8, _e2292.member_9, _e2292.member_10, _e2292.member_11, _e2292.member_12, select(select(-2i, -3i, _e2274), -1i, ((_e2239 >= 1e30f) && (_e2270 >= 1e30f))), _e2292.member_14);
phi_4734_ = type_21(_e2195.member, _e2195.member_1, select(1.1754944e-38f, _e589.member_3, (_e589.member_3 > 1.1754944e-38f)), _e2195.member_3, _e2195.member_4);
phi_4735_ = type_20(_e2307.member, _e2307.member_1, _e2307.member_2, _e2307.member_3, _e2307.member_4, _e2307.member_5, _e2307.member_6, _e2307.member_7, _e2307.member_8, _e2307.member_9, _e2307.member_10, _e2307.member_11, _e2307.member_12, _e2307.member_13, select(_e2239, _e2270, _e2274));
phi_4736_ = _e630;
} else {
let _e695 = select(_e659, _e656, (_e656 < _e659));
let _e701 = global_3.member[bitcast<u32>(select(0i, _e695, (_e695 > 0i)))];
let _e702 = (_e656 + 1i);
let _e704 = select(_e659, _e702, (_e702 < _e659));
let _e710 = global_3.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e711 = (_e656 + 2i);
let _e713 = select(_e659, _e711, (_e711 < _e659));
let _e719 = global_3.member[bitcast<u32>(select(0i, _e713, (_e713 > 0i)))];
let _e720 = (_e656 + 3i);
let _e722 = select(_e659, _e720, (_e720 < _e659));
let _e728 = global_3.member[bitcast<u32>(select(0i, _e722, (_e722 > 0i)))];
let _e729 = (_e656 + 4i);
let _e731 = select(_e659, _e729, (_e729 < _e659));
let _e737 = global_3.member[bitcast<u32>(select(0i, _e731, (_e731 > 0i)))];
let _e738 = (_e656 + 5i);
let _e740 = select(_e659, _e738, (_e738 < _e659));
let _e746 = global_3.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e747 = (_e728 - _e701);
let _e748 = (_e737 - _e710);
let _e749 = (_e746 - _e719);
let _e750 = (_e656 + 6i);
let _e752 = select(_e659, _e750, (_e750 < _e659));
let _e758 = global_3.member[bitcast<u32>(select(0i, _e752, (_e752 > 0i)))];
let _e759 = (_e656 + 7i);
let _e761 = select(_e659, _e759, (_e759 < _e659));
let _e767 = global_3.member[bitcast<u32>(select(0i, _e761, (_e761 > 0i)))];
let _e768 = (_e656 + 8i);
let _e770 = select(_e659, _e768, (_e768 < _e659));
let _e776 = global_3.member[bitcast<u32>(select(0i, _e770, (_e770 > 0i)))];
let _e777 = (_e758 - _e701);
let _e778 = (_e767 - _e710);
let _e779 = (_e776 - _e719);
let _e782 = ((_e748 * _e779) - (_e749 * _e778));
let _e785 = ((_e749 * _e777) - (_e747 * _e779));
let _e788 = ((_e747 * _e778) - (_e748 * _e777));
let _e793 = (((_e782 * _e782) + (_e785 * _e785)) + (_e788 * _e788));
let _e796 = sqrt(select(0f, _e793, (_e793 > 0f)));
let _e799 = (1f / select(1e-20f, _e796, (_e796 > 1e-20f)));
let _e800 = (_e782 * _e799);
let _e801 = (_e785 * _e799);
let _e802 = (_e788 * _e799);
let _e808 = bitcast<f32>((bitcast<u32>(_e591.member_1.x) & 2147483647u));
let _e812 = bitcast<f32>((bitcast<u32>(_e591.member_1.y) & 2147483647u));
let _e816 = bitcast<f32>((bitcast<u32>(_e591.member_1.z) & 2147483647u));
let _e819 = ((_e808 >= _e812) && (_e808 >= _e816));
let _e822 = (!(_e819) && (_e812 >= _e816));
let _e829 = (1f / select(select(_e591.member_1.z, _e591.member_1.y, _e822), _e591.member_1.x, _e819));
let _e830 = (select(select(_e591.member_1.x, _e591.member_1.z, _e822), _e591.member_1.y, _e819) * _e829);
let _e831 = (select(select(_e591.member_1.y, _e591.member_1.x, _e822), _e591.member_1.z, _e819) * _e829);
let _e833 = (_e701 - _e591.member.x);
let _e835 = (_e710 - _e591.member.y);
let _e837 = (_e719 - _e591.member.z);
let _e843 = select(select(_e837, _e835, _e822), _e833, _e819);
let _e845 = (select(select(_e833, _e837, _e822), _e835, _e819) - (_e830 * _e843));
let _e847 = (select(select(_e835, _e833, _e822), _e837, _e819) - (_e831 * _e843));
let _e848 = (_e728 - _e591.member.x);
let _e849 = (_e737 - _e591.member.y);
let _e850 = (_e746 - _e591.member.z);
let _e856 = select(select(_e850, _e849, _e822), _e848, _e819);
let _e858 = (select(select(_e848, _e850, _e822), _e849, _e819) - (_e830 * _e856));
let _e860 = (select(select(_e849, _e848, _e822), _e850, _e819) - (_e831 * _e856));
let _e861 = (_e758 - _e591.member.x);
let _e862 = (_e767 - _e591.member.y);
let _e863 = (_e776 - _e591.member.z);
let _e869 = select(select(_e863, _e862, _e822), _e861, _e819);
let _e871 = (select(select(_e861, _e863, _e822), _e862, _e819) - (_e830 * _e869));
let _e873 = (select(select(_e862, _e861, _e822), _e863, _e819) - (_e831 * _e869));
let _e876 = ((_e871 * _e860) - (_e873 * _e858));
let _e879 = ((_e845 * _e873) - (_e847 * _e871));
let _e882 = ((_e858 * _e847) - (_e860 * _e845));
let _e884 = ((_e876 + _e879) + _e882);
let _e887 = (1f / select(_e884, 1f, (_e884 == 0f)));
let _e888 = (_e876 * _e887);
let _e889 = (_e879 * _e887);
let _e890 = (_e882 * _e887);
let _e891 = (_e656 + 9i);
let _e893 = select(_e659, _e891, (_e891 < _e659));
let _e899 = global_3.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
let _e900 = (_e656 + 10i);
let _e902 = select(_e659, _e900, (_e900 < _e659));
let _e908 = global_3.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e909 = (_e656 + 11i);
let _e911 = select(_e659, _e909, (_e909 < _e659));
let _e917 = global_3.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e921 = (_e656 + 12i);
let _e923 = select(_e659, _e921, (_e921 < _e659));
let _e929 = global_3.member[bitcast<u32>(select(0i, _e923, (_e923 > 0i)))];
let _e930 = (_e656 + 13i);
let _e932 = select(_e659, _e930, (_e930 < _e659));
let _e938 = global_3.member[bitcast<u32>(select(0i, _e932, (_e932 > 0i)))];
let _e939 = (_e656 + 14i);
let _e941 = select(_e659, _e939, (_e939 < _e659));
let _e947 = global_3.member[bitcast<u32>(select(0i, _e941, (_e941 > 0i)))];
let _e954 = (_e656 + 15i);
let _e956 = select(_e659, _e954, (_e954 < _e659));
let _e962 = global_3.member[bitcast<u32>(select(0i, _e956, (_e956 > 0i)))];
let _e963 = (_e656 + 16i);
let _e965 = select(_e659, _e963, (_e963 < _e659));
let _e971 = global_3.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e972 = (_e656 + 17i);
let _e974 = select(_e659, _e972, (_e972 < _e659));
let _e980 = global_3.member[bitcast<u32>(select(0i, _e974, (_e974 > 0i)))];
let _e984 = (((_e899 * _e888) + (_e929 * _e889)) + (_e962 * _e890));
let _e985 = (((_e908 * _e888) + (_e938 * _e889)) + (_e971 * _e890));
let _e986 = (((_e917 * _e888) + (_e947 * _e889)) + (_e980 * _e890));
let _e991 = (((_e984 * _e984) + (_e985 * _e985)) + (_e986 * _e986));
let _e994 = sqrt(select(0f, _e991, (_e991 > 0f)));
let _e997 = (1f / select(1e-20f, _e994, (_e994 > 1e-20f)));
let _e998 = (_e984 * _e997);
let _e999 = (_e985 * _e997);
let _e1000 = (_e986 * _e997);
let _e1002 = local_3;
let _e1003 = (_e1002 * 4i);
let _e1005 = select(_e677, _e1003, (_e1003 < _e677));
let _e1011 = global_4.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1012 = select(_e1011, 1f, _e652);
let _e1014 = local_4;
let _e1015 = (_e1014 * 4i);
let _e1017 = select(_e677, _e1015, (_e1015 < _e677));
let _e1023 = global_4.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1025 = local_5;
let _e1027 = select(_e1023, 1f, (_e1025 == 16i));
let _e1034 = select(1f, -1f, ((((_e591.member_1.x * _e998) + (_e591.member_1.y * _e999)) + (_e591.member_1.z * _e1000)) > 0f));
let _e1035 = (_e998 * _e1034);
let _e1036 = (_e999 * _e1034);
let _e1037 = (_e1000 * _e1034);
let _e1043 = -((((_e591.member_1.x * _e1035) + (_e591.member_1.y * _e1036)) + (_e591.member_1.z * _e1037)));
let _e1045 = select(0f, _e1043, (_e1043 > 0f));
let _e1046 = (_e1012 / _e1027);
let _e1047 = (_e1046 * _e1046);
let _e1051 = (1f - (_e1047 * (1f - (_e1045 * _e1045))));
let _e1052 = (_e1051 <= 0f);
let _e1060 = ((_e1046 * _e1045) - sqrt(select(0f, _e1051, (_e1051 > 0f))));
let _e1067 = (2f * _e1045);
let _e1074 = select(((_e591.member_1.x * _e1046) + (_e1035 * _e1060)), (_e591.member_1.x + (_e1035 * _e1067)), _e1052);
let _e1075 = select(((_e591.member_1.y * _e1046) + (_e1036 * _e1060)), (_e591.member_1.y + (_e1036 * _e1067)), _e1052);
let _e1076 = select(((_e591.member_1.z * _e1046) + (_e1037 * _e1060)), (_e591.member_1.z + (_e1037 * _e1067)), _e1052);
let _e1081 = (((_e1074 * _e1074) + (_e1075 * _e1075)) + (_e1076 * _e1076));
let _e1084 = sqrt(select(0f, _e1081, (_e1081 > 0f)));
let _e1087 = (1f / select(1e-20f, _e1084, (_e1084 > 1e-20f)));
let _e1095 = (((_e591.member_1.x * _e800) + (_e591.member_1.y * _e801)) + (_e591.member_1.z * _e802));
let _e1112 = ((((((_e998 * _e591.member_1.x) + (_e999 * _e591.member_1.y)) + (_e1000 * _e591.member_1.z)) * _e1095) > 0f) && (((((((_e1074 * _e1087) * _e800) + ((_e1075 * _e1087) * _e801)) + ((_e1076 * _e1087) * _e802)) * select(1f, -1f, _e1052)) * _e1095) > 0f));
let _e1113 = select(_e800, _e998, _e1112);
let _e1114 = select(_e801, _e999, _e1112);
let _e1115 = select(_e802, _e1000, _e1112);
let _e1119 = (_e591.member_14 - _e589.member_2);
let _e1121 = select(0f, _e1119, (_e1119 > 0f));
let _e1123 = local_6;
if (_e1123 != 16i) {
let _e1141 = type_20(_e591.member, _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, _e591.member_6, _e591.member_7, _e591.member_8, (_e591.member_9 + _e1121), _e591.member_10, _e591.member_11, _e591.member_12, _e591.member_13, _e591.member_14);
let _e1142 = (_e1003 + 1i);
let _e1144 = select(_e677, _e1142, (_e1142 < _e677));
let _e1150 = global_4.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1152 = -((_e1150 * _e1121));
let _e1154 = select(-87f, _e1152, (_e1152 > -87f));
let _e1156 = select(88f, _e1154, (_e1154 < 88f));
let _e1158 = ((_e1156 * 1.442695f) + 0.5f);
let _e1160 = select(-127f, _e1158, (_e1158 > -127f));
let _e1162 = select(128f, _e1160, (_e1160 < 128f));
let _e1169 = select(0i, select(select(i32(_e1162), i32(-2147483648), (_e1162 < -2147483600f)), 2147483647i, (_e1162 > 2147483500f)), (_e1162 == _e1162));
let _e1173 = (_e1169 - select(0i, 1i, (_e1162 < f32(_e1169))));
let _e1174 = f32(_e1173);
let _e1178 = ((_e1156 - (_e1174 * 0.6933594f)) - (_e1174 * -2.1219444e-4f));
let _e1202 = (_e1003 + 2i);
let _e1204 = select(_e677, _e1202, (_e1202 < _e677));
let _e1210 = global_4.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1212 = -((_e1210 * _e1121));
let _e1214 = select(-87f, _e1212, (_e1212 > -87f));
let _e1216 = select(88f, _e1214, (_e1214 < 88f));
let _e1218 = ((_e1216 * 1.442695f) + 0.5f);
let _e1220 = select(-127f, _e1218, (_e1218 > -127f));
let _e1222 = select(128f, _e1220, (_e1220 < 128f));
let _e1229 = select(0i, select(select(i32(_e1222), i32(-2147483648), (_e1222 < -2147483600f)), 2147483647i, (_e1222 > 2147483500f)), (_e1222 == _e1222));
let _e1233 = (_e1229 - select(0i, 1i, (_e1222 < f32(_e1229))));
let _e1234 = f32(_e1233);
let _e1238 = ((_e1216 - (_e1234 * 0.6933594f)) - (_e1234 * -2.1219444e-4f));
let _e1262 = (_e1003 + 3i);
let _e1264 = select(_e677, _e1262, (_e1262 < _e677));
let _e1270 = global_4.member[bitcast<u32>(select(0i, _e1264, (_e1264 > 0i)))];
let _e1272 = -((_e1270 * _e1121));
let _e1274 = select(-87f, _e1272, (_e1272 > -87f));
let _e1276 = select(88f, _e1274, (_e1274 < 88f));
let _e1278 = ((_e1276 * 1.442695f) + 0.5f);
let _e1280 = select(-127f, _e1278, (_e1278 > -127f));
let _e1282 = select(128f, _e1280, (_e1280 < 128f));
let _e1289 = select(0i, select(select(i32(_e1282), i32(-2147483648), (_e1282 < -2147483600f)), 2147483647i, (_e1282 > 2147483500f)), (_e1282 == _e1282));
let _e1293 = (_e1289 - select(0i, 1i, (_e1282 < f32(_e1289))));
let _e1294 = f32(_e1293);
let _e1298 = ((_e1276 - (_e1294 * 0.6933594f)) - (_e1294 * -2.1219444e-4f));
phi_3715_ = type_20(_e1141.member, _e1141.member_1, vec3<f32>((_e591.member_2.x * ((1f + (_e1178 * (1f + (_e1178 * (0.5f + (_e1178 * (0.16666667f + (_e1178 * (0.041666668f + (_e1178 * (0.008333334f + (_e1178 * (0.001388889f + (_e1178 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1173 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.y * ((1f + (_e1238 * (1f + (_e1238 * (0.5f + (_e1238 * (0.16666667f + (_e1238 * (0.041666668f + (_e1238 * (0.008333334f + (_e1238 * (0.001388889f + (_e1238 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1233 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.z * ((1f + (_e1298 * (1f + (_e1298 * (0.5f + (_e1298 * (0.16666667f + (_e1298 * (0.041666668f + (_e1298 * (0.008333334f + (_e1298 * (0.001388889f + (_e1298 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1293 + 127i)) << bitcast<u32>(23i)))))), _e1141.member_3, _e1141.member_4, _e1141.member_5, _e1141.member_6, _e1141.member_7, _e1141.member_8, _e1141.member_9, _e1141.member_10, _e1141.member_11, _e1141.member_12, _e1141.member_13, _e1141.member_14);
} else {
phi_3715_ = _e591;
}
let _e1339 = phi_3715_;
let _e1372 = type_20(vec3<f32>((_e1339.member.x + (_e1339.member_1.x * _e1339.member_14)), (_e1339.member.y + (_e1339.member_1.y * _e1339.member_14)), (_e1339.member.z + (_e1339.member_1.z * _e1339.member_14))), _e1339.member_1, _e1339.member_2, _e1339.member_3, _e1339.member_4, _e1339.member_5, _e1339.member_6, _e1339.member_7, _e1339.member_8, _e1339.member_9, _e1339.member_10, _e1339.member_11, _e1339.member_12, _e1339.member_13, _e1339.member_14);
let _e1389 = type_20(_e1372.member, _e1372.member_1, _e1372.member_2, _e1372.member_3, _e1372.member_4, (_e1339.member_5 + _e1339.member_14), _e1372.member_6, _e1372.member_7, _e1372.member_8, _e1372.member_9, _e1372.member_10, _e1372.member_11, _e1372.member_12, _e1372.member_13, _e1372.member_14);
let _e1391 = (_e1339.member_8 == 0f);
let _e1409 = type_20(_e1389.member, _e1389.member_1, _e1389.member_2, _e1389.member_3, _e1389.member_4, _e1389.member_5, _e1389.member_6, _e1389.member_7, _e1389.member_8, _e1389.member_9, (_e1339.member_10 + select(0f, _e1339.member_14, _e1391)), _e1389.member_11, _e1389.member_12, _e1389.member_13, _e1389.member_14);
let _e1414 = type_21(0i, _e589.member_1, _e589.member_2, _e589.member_3, _e589.member_4);
let _e1419 = type_21(_e1414.member, 0i, _e1414.member_2, _e1414.member_3, _e1414.member_4);
let _e1431 = select(1f, -1f, ((((_e1339.member_1.x * _e1113) + (_e1339.member_1.y * _e1114)) + (_e1339.member_1.z * _e1115)) > 0f));
let _e1432 = (_e1113 * _e1431);
let _e1433 = (_e1114 * _e1431);
let _e1434 = (_e1115 * _e1431);
let _e1440 = -((((_e1339.member_1.x * _e1432) + (_e1339.member_1.y * _e1433)) + (_e1339.member_1.z * _e1434)));
let _e1442 = select(0f, _e1440, (_e1440 > 0f));
let _e1443 = (_e1442 * _e1442);
let _e1446 = (1f - (_e1047 * (1f - _e1443)));
let _e1447 = (_e1446 <= 0f);
let _e1455 = ((_e1046 * _e1442) - sqrt(select(0f, _e1446, (_e1446 > 0f))));
let _e1462 = (2f * _e1442);
let _e1469 = select(((_e1339.member_1.x * _e1046) + (_e1432 * _e1455)), (_e1339.member_1.x + (_e1432 * _e1462)), _e1447);
let _e1470 = select(((_e1339.member_1.y * _e1046) + (_e1433 * _e1455)), (_e1339.member_1.y + (_e1433 * _e1462)), _e1447);
let _e1471 = select(((_e1339.member_1.z * _e1046) + (_e1434 * _e1455)), (_e1339.member_1.z + (_e1434 * _e1462)), _e1447);
let _e1476 = (((_e1469 * _e1469) + (_e1470 * _e1470)) + (_e1471 * _e1471));
let _e1479 = sqrt(select(0f, _e1476, (_e1476 > 0f)));
let _e1482 = (1f / select(1e-20f, _e1479, (_e1479 > 1e-20f)));
let _e1487 = (_e1027 / _e1012);
let _e1490 = (((_e1487 * _e1487) - 1f) + _e1443);
let _e1493 = sqrt(select(0f, _e1490, (_e1490 > 0f)));
let _e1494 = (_e1493 - _e1442);
let _e1495 = (_e1493 + _e1442);
let _e1498 = (_e1494 / select(1e-6f, _e1495, (_e1495 > 1e-6f)));
let _e1502 = ((_e1442 * _e1494) + 1f);
let _e1505 = (((_e1442 * _e1495) - 1f) / select(1e-6f, _e1502, (_e1502 > 1e-6f)));
let _e1517 = global_1.member.member_1;
let _e1520 = select(0f, select(select((((0.5f * _e1498) * _e1498) * (1f + (_e1505 * _e1505))), 1f, (_e1490 <= 0f)), 0f, (_e1012 == _e1027)), ((_e1517 & 1u) != 0u));
if _e1391 {
let _e1535 = type_20(_e1409.member, _e1409.member_1, _e1409.member_2, vec3<f32>(_e1113, _e1114, _e1115), _e1409.member_4, _e1409.member_5, _e1409.member_6, _e1409.member_7, _e1409.member_8, _e1409.member_9, _e1409.member_10, _e1409.member_11, _e1409.member_12, _e1409.member_13, _e1409.member_14);
phi_4215_ = type_20(_e1535.member, _e1535.member_1, _e1535.member_2, _e1535.member_3, _e1535.member_4, _e1535.member_5, _e1535.member_6, _e1535.member_7, _e1535.member_8, _e1535.member_9, _e1535.member_10, _e1520, _e1535.member_12, _e1535.member_13, _e1535.member_14);
} else {
phi_4215_ = _e1409;
}
let _e1552 = phi_4215_;
let _e1554 = (_e1552.member_8 + 1f);
let _e1569 = type_20(_e1552.member, _e1552.member_1, _e1552.member_2, _e1552.member_3, _e1552.member_4, _e1552.member_5, _e1552.member_6, _e1552.member_7, _e1554, _e1552.member_9, _e1552.member_10, _e1552.member_11, _e1552.member_12, _e1552.member_13, _e1552.member_14);
let _e1572 = ((_e110.member_2 == 0u) && (_e1554 >= 2f));
if (_e1447 && _e1572) {
let _e1597 = (((_e1552.member_1.x * _e1113) + (_e1552.member_1.y * _e1114)) + (_e1552.member_1.z * _e1115));
let _e1601 = (_e1552.member_1.x - (_e1113 * _e1597));
let _e1602 = (_e1552.member_1.y - (_e1114 * _e1597));
let _e1603 = (_e1552.member_1.z - (_e1115 * _e1597));
let _e1608 = (((_e1601 * _e1601) + (_e1602 * _e1602)) + (_e1603 * _e1603));
let _e1611 = sqrt(select(0f, _e1608, (_e1608 > 0f)));
let _e1614 = (1f / select(1e-20f, _e1611, (_e1611 > 1e-20f)));
phi_4268_ = type_20(_e1569.member, vec3<f32>((_e1601 * _e1614), (_e1602 * _e1614), (_e1603 * _e1614)), _e1569.member_2, _e1569.member_3, _e1569.member_4, _e1569.member_5, _e1569.member_6, _e1569.member_7, _e1569.member_8, _e1569.member_9, _e1569.member_10, _e1569.member_11, _e1569.member_12, _e1569.member_13, _e1569.member_14);
} else {
phi_4268_ = type_20(_e1569.member, vec3<f32>((_e1469 * _e1482), (_e1470 * _e1482), (_e1471 * _e1482)), _e1569.member_2, _e1569.member_3, _e1569.member_4, _e1569.member_5, _e1569.member_6, _e1569.member_7, _e1569.member_8, _e1569.member_9, _e1569.member_10, _e1569.member_11, _e1569.member_12, _e1569.member_13, _e1569.member_14);
}
let _e1635 = phi_4268_;
if _e1447 {
phi_4282_ = _e1635;
} else {
let _e1636 = (1f - _e1520);
phi_4282_ = type_20(_e1635.member, _e1635.member_1, vec3<f32>((_e1635.member_2.x * _e1636), (_e1635.member_2.y * _e1636), (_e1635.member_2.z * _e1636)), _e1635.member_3, _e1635.member_4, _e1635.member_5, _e1635.member_6, _e1635.member_7, _e1635.member_8, _e1635.member_9, _e1635.member_10, _e1635.member_11, _e1635.member_12, _e1635.member_13, _e1635.member_14);
}
let _e1663 = phi_4282_;
let _e1670 = global_1.member.member_17.member.member;
let _e1684 = ((((_e1670.member.member * _e1663.member.x) + (_e1670.member.member_1 * _e1663.member.y)) + (_e1670.member.member_2 * _e1663.member.z)) + _e1670.member_1);
let _e1693 = -((((_e1670.member.member * _e1663.member_1.x) + (_e1670.member.member_1 * _e1663.member_1.y)) + (_e1670.member.member_2 * _e1663.member_1.z)));
let _e1695 = (_e1693 > 1e-9f);
let _e1699 = ((_e1684 / select(1e-9f, _e1693, _e1695)) - 0.015625f);
let _e1702 = select(1e30f, select(0f, _e1699, (_e1699 > 0f)), ((_e1684 > 0f) && _e1695));
let _e1707 = global_1.member.member_17.member_1.member;
let _e1718 = ((((_e1707.member.member * _e1663.member.x) + (_e1707.member.member_1 * _e1663.member.y)) + (_e1707.member.member_2 * _e1663.member.z)) + _e1707.member_1);
let _e1724 = -((((_e1707.member.member * _e1663.member_1.x) + (_e1707.member.member_1 * _e1663.member_1.y)) + (_e1707.member.member_2 * _e1663.member_1.z)));
let _e1726 = (_e1724 > 1e-9f);
let _e1730 = ((_e1718 / select(1e-9f, _e1724, _e1726)) - 0.015625f);
let _e1733 = select(1e30f, select(0f, _e1730, (_e1730 > 0f)), ((_e1718 > 0f) && _e1726));
let _e1737 = (_e1733 < _e1702);
let _e1739 = select(select(-2i, -3i, _e1737), -1i, ((_e1702 >= 1e30f) && (_e1733 >= 1e30f)));
let _e1740 = select(_e1702, _e1733, _e1737);
let _e1755 = type_20(_e1663.member, _e1663.member_1, _e1663.member_2, _e1663.member_3, _e1663.member_4, _e1663.member_5, _e1663.member_6, _e1663.member_7, _e1663.member_8, _e1663.member_9, _e1663.member_10, _e1663.member_11, 0i, _e1663.member_13, _e1663.member_14);
let _e1770 = type_20(_e1755.member, _e1755.member_1, _e1755.member_2, _e1755.member_3, _e1755.member_4, _e1755.member_5, _e1755.member_6, _e1755.member_7, _e1755.member_8, _e1755.member_9, _e1755.member_10, _e1755.member_11, _e1755.member_12, _e1739, _e1755.member_14);
let _e1785 = type_20(_e1770.member, _e1770.member_1, _e1770.member_2, _e1770.member_3, _e1770.member_4, _e1770.member_5, _e1770.member_6, _e1770.member_7, _e1770.member_8, _e1770.member_9, _e1770.member_10, _e1770.member_11, _e1770.member_12, _e1770.member_13, _e1740);
let _e1787 = local_7;
let _e1789 = local_8;
let _e1792 = ((_e1517 & 2u) != 0u);
if (_e1572 && !(_e1792)) {
if (_e1739 == -1i) {
phi_4707_ = type_20(_e1785.member, _e1785.member_1, _e1785.member_2, _e1785.member_3, _e1785.member_4, _e1785.member_5, 1f, _e1785.member_7, _e1785.member_8, _e1785.member_9, _e1785.member_10, _e1785.member_11, _e1785.member_12, _e1785.member_13, _e1785.member_14);
} else {
let _e1868 = type_20(vec3<f32>((_e1663.member.x + (_e1663.member_1.x * _e1740)), (_e1663.member.y + (_e1663.member_1.y * _e1740)), (_e1663.member.z + (_e1663.member_1.z * _e1740))), _e1785.member_1, _e1785.member_2, _e1785.member_3, _e1785.member_4, _e1785.member_5, _e1785.member_6, _e1785.member_7, _e1785.member_8, _e1785.member_9, _e1785.member_10, _e1785.member_11, _e1785.member_12, _e1785.member_13, _e1785.member_14);
let _e1885 = type_20(_e1868.member, _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, (_e1663.member_5 + _e1740), _e1868.member_6, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14);
let _e1901 = type_20(_e1885.member, _e1885.member_1, _e1885.member_2, _e1885.member_3, _e1885.member_4, _e1885.member_5, _e1885.member_6, _e1885.member_7, _e1885.member_8, _e1885.member_9, _e1885.member_10, _e1885.member_11, _e1885.member_12, _e1885.member_13, (_e1740 - _e1740));
let _e1921 = type_20(_e1901.member, _e1901.member_1, _e1901.member_2, _e1901.member_3, _e1901.member_4, _e1901.member_5, _e1901.member_6, _e1901.member_7, _e1901.member_8, _e1901.member_9, (_e1663.member_10 + select(0f, _e1740, (_e1663.member_8 == 0f))), _e1901.member_11, _e1901.member_12, _e1901.member_13, _e1901.member_14);
phi_4707_ = type_20(_e1921.member, _e1921.member_1, _e1921.member_2, _e1921.member_3, _e1921.member_4, _e1921.member_5, 3f, _e1921.member_7, _e1921.member_8, _e1921.member_9, _e1921.member_10, _e1921.member_11, _e1921.member_12, _e1921.member_13, _e1921.member_14);
}
let _e1953 = phi_4707_;
phi_4728_ = _e1953;
} else {
let _e1799 = global_1.member.member_5;
if ((!(_e1572) && (_e1663.member_8 >= f32(bitcast<i32>(_e1799)))) && (select(_e1789, _e1787, _e1447) != 16i)) {
phi_4727_ = type_20(_e1785.member, _e1785.member_1, _e1785.member_2, _e1785.member_3, _e1785.member_4, _e1785.member_5, 2f, _e1785.member_7, _e1785.member_8, _e1785.member_9, _e1785.member_10, _e1785.member_11, _e1785.member_12, _e1785.member_13, _e1785.member_14);
} else {
if _e1792 {
phi_4726_ = type_20(_e1785.member, _e1785.member_1, _e1785.member_2, _e1785.member_3, _e1785.member_4, _e1785.member_5, 4f, _e1785.member_7, _e1785.member_8, _e1785.member_9, _e1785.member_10, _e1785.member_11, _e1785.member_12, _e1785.member_13, _e1785.member_14);
} else {
phi_4726_ = _e1785;
}
let _e1822 = phi_4726_;
phi_4727_ = _e1822;
}
let _e1839 = phi_4727_;
phi_4728_ = _e1839;
}
let _e1955 = phi_4728_;
phi_4734_ = type_21(_e1419.member, _e1419.member_1, 0f, _e1419.member_3, _e1419.member_4);
phi_4735_ = _e1955;
phi_4736_ = select(_e595, _e630, !(_e1447));
}
let _e2324 = phi_4734_;
let _e2326 = phi_4735_;
let _e2328 = phi_4736_;
phi_4737_ = _e2324;
phi_4738_ = _e2326;
phi_4739_ = _e2328;
}
let _e2330 = phi_4737_;
let _e2332 = phi_4738_;
let _e2334 = phi_4739_;
phi_4741_ = _e2330;
phi_4742_ = _e2332;
phi_4743_ = _e2334;
phi_4745_ = select(true, false, _e688);
}
let _e2337 = phi_4741_;
let _e2339 = phi_4742_;
let _e2341 = phi_4743_;
let _e2343 = phi_4745_;
phi_4756_ = _e2337;
phi_4757_ = _e2339;
phi_4758_ = _e2341;
phi_4760_ = select(_e688, false, _e654);
phi_4761_ = _e2343;
} else {
phi_4756_ = type_21();
phi_4757_ = type_20();
phi_4758_ = i32();
phi_4760_ = select(true, false, _e654);
phi_4761_ = false;
}
let _e2346 = phi_4756_;
let _e2348 = phi_4757_;
let _e2350 = phi_4758_;
let _e2352 = phi_4760_;
let _e2354 = phi_4761_;
if _e654 {
if _e649 {
phi_5058_ = type_20(_e591.member, _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, 1f, _e591.member_7, _e591.member_8, _e591.member_9, _e591.member_10, _e591.member_11, _e591.member_12, _e591.member_13, _e591.member_14);
} else {
let _e2387 = type_20(vec3<f32>((_e591.member.x + (_e591.member_1.x * _e591.member_14)), (_e591.member.y + (_e591.member_1.y * _e591.member_14)), (_e591.member.z + (_e591.member_1.z * _e591.member_14))), _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, _e591.member_6, _e591.member_7, _e591.member_8, _e591.member_9, _e591.member_10, _e591.member_11, _e591.member_12, _e591.member_13, _e591.member_14);
let _e2404 = type_20(_e2387.member, _e2387.member_1, _e2387.member_2, _e2387.member_3, _e2387.member_4, (_e591.member_5 + _e591.member_14), _e2387.member_6, _e2387.member_7, _e2387.member_8, _e2387.member_9, _e2387.member_10, _e2387.member_11, _e2387.member_12, _e2387.member_13, _e2387.member_14);
let _e2420 = type_20(_e2404.member, _e2404.member_1, _e2404.member_2, _e2404.member_3, _e2404.member_4, _e2404.member_5, _e2404.member_6, _e2404.member_7, _e2404.member_8, _e2404.member_9, _e2404.member_10, _e2404.member_11, _e2404.member_12, _e2404.member_13, (_e591.member_14 - _e591.member_14));
let _e2440 = type_20(_e2420.member, _e2420.member_1, _e2420.member_2, _e2420.member_3, _e2420.member_4, _e2420.member_5, _e2420.member_6, _e2420.member_7, _e2420.member_8, _e2420.member_9, (_e591.member_10 + select(0f, _e591.member_14, (_e591.member_8 == 0f))), _e2420.member_11, _e2420.member_12, _e2420.member_13, _e2420.member_14);
phi_5058_ = type_20(_e2440.member, _e2440.member_1, _e2440.member_2, _e2440.member_3, _e2440.member_4, _e2440.member_5, 3f, _e2440.member_7, _e2440.member_8, _e2440.member_9, _e2440.member_10, _e2440.member_11, _e2440.member_12, _e2440.member_13, _e2440.member_14);
}
let _e2472 = phi_5058_;
phi_5059_ = _e2472;
} else {
phi_5059_ = type_20();
}
let _e2474 = phi_5059_;
let _e2475 = select(_e2352, false, _e654);
if _e2475 {
let _e2479 = (_e591.member_14 - _e589.member_2);
let _e2481 = select(0f, _e2479, (_e2479 > 0f));
let _e2483 = local_11;
if (_e2483 != 16i) {
let _e2501 = type_20(_e591.member, _e591.member_1, _e591.member_2, _e591.member_3, _e591.member_4, _e591.member_5, _e591.member_6, _e591.member_7, _e591.member_8, (_e591.member_9 + _e2481), _e591.member_10, _e591.member_11, _e591.member_12, _e591.member_13, _e591.member_14);
let _e2503 = local_12;
let _e2504 = (_e2503 * 4i);
let _e2505 = (_e2504 + 1i);
let _e2507 = (bitcast<i32>(_e103) - 1i);
let _e2509 = select(_e2507, _e2505, (_e2505 < _e2507));
let _e2515 = global_4.member[bitcast<u32>(select(0i, _e2509, (_e2509 > 0i)))];
let _e2517 = -((_e2515 * _e2481));
let _e2519 = select(-87f, _e2517, (_e2517 > -87f));
let _e2521 = select(88f, _e2519, (_e2519 < 88f));
let _e2523 = ((_e2521 * 1.442695f) + 0.5f);
let _e2525 = select(-127f, _e2523, (_e2523 > -127f));
let _e2527 = select(128f, _e2525, (_e2525 < 128f));
let _e2534 = select(0i, select(select(i32(_e2527), i32(-2147483648), (_e2527 < -2147483600f)), 2147483647i, (_e2527 > 2147483500f)), (_e2527 == _e2527));
let _e2538 = (_e2534 - select(0i, 1i, (_e2527 < f32(_e2534))));
let _e2539 = f32(_e2538);
let _e2543 = ((_e2521 - (_e2539 * 0.6933594f)) - (_e2539 * -2.1219444e-4f));
let _e2567 = (_e2504 + 2i);
let _e2569 = select(_e2507, _e2567, (_e2567 < _e2507));
let _e2575 = global_4.member[bitcast<u32>(select(0i, _e2569, (_e2569 > 0i)))];
let _e2577 = -((_e2575 * _e2481));
let _e2579 = select(-87f, _e2577, (_e2577 > -87f));
let _e2581 = select(88f, _e2579, (_e2579 < 88f));
let _e2583 = ((_e2581 * 1.442695f) + 0.5f);
let _e2585 = select(-127f, _e2583, (_e2583 > -127f));
let _e2587 = select(128f, _e2585, (_e2585 < 128f));
let _e2594 = select(0i, select(select(i32(_e2587), i32(-2147483648), (_e2587 < -2147483600f)), 2147483647i, (_e2587 > 2147483500f)), (_e2587 == _e2587));
let _e2598 = (_e2594 - select(0i, 1i, (_e2587 < f32(_e2594))));
let _e2599 = f32(_e2598);
let _e2603 = ((_e2581 - (_e2599 * 0.6933594f)) - (_e2599 * -2.1219444e-4f));
let _e2627 = (_e2504 + 3i);
let _e2629 = select(_e2507, _e2627, (_e2627 < _e2507));
let _e2635 = global_4.member[bitcast<u32>(select(0i, _e2629, (_e2629 > 0i)))];
let _e2637 = -((_e2635 * _e2481));
let _e2639 = select(-87f, _e2637, (_e2637 > -87f));
let _e2641 = select(88f, _e2639, (_e2639 < 88f));
let _e2643 = ((_e2641 * 1.442695f) + 0.5f);
let _e2645 = select(-127f, _e2643, (_e2643 > -127f));
let _e2647 = select(128f, _e2645, (_e2645 < 128f));
let _e2654 = select(0i, select(select(i32(_e2647), i32(-2147483648), (_e2647 < -2147483600f)), 2147483647i, (_e2647 > 2147483500f)), (_e2647 == _e2647));
let _e2658 = (_e2654 - select(0i, 1i, (_e2647 < f32(_e2654))));
let _e2659 = f32(_e2658);
let _e2663 = ((_e2641 - (_e2659 * 0.6933594f)) - (_e2659 * -2.1219444e-4f));
phi_5326_ = type_20(_e2501.member, _e2501.member_1, vec3<f32>((_e591.member_2.x * ((1f + (_e2543 * (1f + (_e2543 * (0.5f + (_e2543 * (0.16666667f + (_e2543 * (0.041666668f + (_e2543 * (0.008333334f + (_e2543 * (0.001388889f + (_e2543 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2538 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.y * ((1f + (_e2603 * (1f + (_e2603 * (0.5f + (_e2603 * (0.16666667f + (_e2603 * (0.041666668f + (_e2603 * (0.008333334f + (_e2603 * (0.001388889f + (_e2603 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2598 + 127i)) << bitcast<u32>(23i))))), (_e591.member_2.z * ((1f + (_e2663 * (1f + (_e2663 * (0.5f + (_e2663 * (0.16666667f + (_e2663 * (0.041666668f + (_e2663 * (0.008333334f + (_e2663 * (0.001388889f + (_e2663 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2658 + 127i)) << bitcast<u32>(23i)))))), _e2501.member_3, _e2501.member_4, _e2501.member_5, _e2501.member_6, _e2501.member_7, _e2501.member_8, _e2501.member_9, _e2501.member_10, _e2501.member_11, _e2501.member_12, _e2501.member_13, _e2501.member_14);
} else {
phi_5326_ = _e591;
}
let _e2704 = phi_5326_;
let _e2737 = type_20(vec3<f32>((_e2704.member.x + (_e2704.member_1.x * _e2704.member_14)), (_e2704.member.y + (_e2704.member_1.y * _e2704.member_14)), (_e2704.member.z + (_e2704.member_1.z * _e2704.member_14))), _e2704.member_1, _e2704.member_2, _e2704.member_3, _e2704.member_4, _e2704.member_5, _e2704.member_6, _e2704.member_7, _e2704.member_8, _e2704.member_9, _e2704.member_10, _e2704.member_11, _e2704.member_12, _e2704.member_13, _e2704.member_14);
let _e2754 = type_20(_e2737.member, _e2737.member_1, _e2737.member_2, _e2737.member_3, _e2737.member_4, (_e2704.member_5 + _e2704.member_14), _e2737.member_6, _e2737.member_7, _e2737.member_8, _e2737.member_9, _e2737.member_10, _e2737.member_11, _e2737.member_12, _e2737.member_13, _e2737.member_14);
let _e2770 = type_20(_e2754.member, _e2754.member_1, _e2754.member_2, _e2754.member_3, _e2754.member_4, _e2754.member_5, _e2754.member_6, _e2754.member_7, _e2754.member_8, _e2754.member_9, _e2754.member_10, _e2754.member_11, _e2754.member_12, _e2754.member_13, (_e2704.member_14 - _e2704.member_14));
let _e2790 = type_20(_e2770.member, _e2770.member_1, _e2770.member_2, _e2770.member_3, _e2770.member_4, _e2770.member_5, _e2770.member_6, _e2770.member_7, _e2770.member_8, _e2770.member_9, (_e2704.member_10 + select(0f, _e2704.member_14, (_e2704.member_8 == 0f))), _e2770.member_11, _e2770.member_12, _e2770.member_13, _e2770.member_14);
phi_5614_ = _e589;
phi_5615_ = type_20(_e2790.member, _e2790.member_1, _e2790.member_2, _e2790.member_3, _e2790.member_4, _e2790.member_5, 3f, _e2790.member_7, _e2790.member_8, _e2790.member_9, _e2790.member_10, _e2790.member_11, _e2790.member_12, _e2790.member_13, _e2790.member_14);
} else {
phi_5614_ = _e2346;
phi_5615_ = _e2348;
}
let _e2807 = phi_5614_;
let _e2809 = phi_5615_;
let _e2811 = select(select(_e2354, false, _e654), true, _e2475);
if _e2811 {
phi_5621_ = _e2807;
phi_5622_ = _e2809;
} else {
phi_5621_ = _e589;
phi_5622_ = _e2474;
}
let _e2813 = phi_5621_;
let _e2815 = phi_5622_;
phi_5624_ = _e2813;
phi_5625_ = _e2815;
phi_5626_ = select(_e595, select(_e2350, _e595, _e2475), _e2811);
}
let _e3443 = phi_5624_;
let _e3445 = phi_5625_;
let _e3447 = phi_5626_;
phi_950_ = _e3443;
phi_953_ = _e3445;
phi_955_ = (_e593 + 1i);
phi_957_ = _e3447;
} else {
phi_950_ = type_21();
phi_953_ = type_20();
phi_955_ = i32();
phi_957_ = i32();
}
let _e3449 = phi_950_;
let _e3451 = phi_953_;
let _e3453 = phi_955_;
let _e3455 = phi_957_;
continue;
continuing {
phi_949_ = _e3449;
phi_952_ = _e3451;
phi_954_ = _e3453;
phi_956_ = _e3455;
break if !(_e599);
}
}
let _e3458 = local_13;
if (_e3458 == 0i) {
phi_5632_ = 16i;
} else {
let _e3461 = local_14;
phi_5632_ = -(_e3461);
}
let _e3464 = phi_5632_;
let _e3466 = local_15;
let _e3470 = local_16;
let _e3474 = local_17;
let _e3477 = local_18;
let _e3480 = local_19;
let _e3484 = local_20;
let _e3488 = local_21;
let _e3492 = local_22;
let _e3496 = local_23;
let _e3500 = local_24;
let _e3504 = local_25;
let _e3508 = local_26;
let _e3512 = local_27;
let _e3516 = local_28;
let _e3520 = local_29;
let _e3524 = local_30;
let _e3529 = local_31;
let _e3532 = local_32;
let _e3535 = local_33;
let _e3538 = local_34;
let _e3541 = local_35;
let _e3545 = local_36;
let _e3549 = local_37;
global_5.member[_e119] = _e3480.member.x;
global_5.member[_e131] = _e3484.member.y;
global_5.member[_e142] = _e3488.member.z;
global_5.member[_e153] = _e3492.member_1.x;
global_5.member[_e164] = _e3496.member_1.y;
global_5.member[_e175] = _e3500.member_1.z;
global_5.member[_e186] = _e3504.member_2.x;
global_5.member[_e197] = _e3508.member_2.y;
global_5.member[_e208] = _e3512.member_2.z;
global_5.member[_e219] = _e3516.member_3.x;
global_5.member[_e230] = _e3520.member_3.y;
global_5.member[_e241] = _e3524.member_3.z;
global_5.member[_e252] = f32(_e3466.member);
global_5.member[_e263] = f32(_e3470.member_1);
global_5.member[_e274] = _e3474.member_2;
global_5.member[_e285] = _e3477.member_3;
let _e3586 = local_38;
global_5.member[_e296] = _e3586;
global_5.member[_e307] = f32(_e3464);
global_5.member[_e318] = _e3529.member_8;
global_5.member[_e329] = _e3532.member_9;
global_5.member[_e340] = _e3535.member_10;
global_5.member[_e351] = _e3538.member_11;
global_5.member[_e362] = f32(_e3541.member_12);
global_5.member[_e373] = f32(_e3545.member_13);
global_5.member[_e384] = _e3549.member_14;
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
