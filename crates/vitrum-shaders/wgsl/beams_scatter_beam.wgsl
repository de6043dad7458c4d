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
struct type_13 {
member: array<f32>,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_18 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_19 {
member: f32,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: type_15,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_16,
member_12: type_17,
member_13: type_18,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_19,
}
struct type_21 {
member: type_20,
}
struct type_22 {
member: f32,
member_1: f32,
}
struct type_25 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage, read_write> global_5: type_25;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var phi_1508_: type_22;
var phi_1918_: f32;
var phi_1921_: u32;
var phi_1919_: f32;
var phi_1922_: u32;
var local_12: u32;
var phi_1951_: f32;
var phi_1954_: u32;
var phi_1952_: f32;
var phi_1955_: u32;
var phi_1966_: u32;
var phi_2018_: f32;
var phi_2021_: u32;
var phi_2019_: f32;
var phi_2022_: u32;
var local_13: u32;
var phi_2051_: f32;
var phi_2054_: u32;
var phi_2052_: f32;
var phi_2055_: u32;
var phi_2066_: u32;
var phi_2077_: u32;
var phi_2117_: f32;
var phi_2120_: u32;
var phi_2118_: f32;
var phi_2121_: u32;
var local_14: u32;
var phi_2150_: f32;
var phi_2153_: u32;
var phi_2151_: f32;
var phi_2154_: u32;
var phi_2165_: u32;
var phi_2176_: u32;
var phi_2219_: i32;
var phi_2322_: i32;
var phi_2339_: u32;
var phi_2342_: f32;
var phi_2379_: u32;
var phi_2380_: u32;
var phi_2411_: i32;
var phi_2412_: i32;
var phi_2476_: i32;
var phi_2479_: f32;
var phi_2511_: i32;
var phi_2522_: i32;
var phi_2607_: u32;
var phi_2610_: u32;
var phi_2608_: u32;
var phi_2611_: u32;
var local_15: u32;
var phi_3020_: u32;
var phi_3030_: f32;
var phi_2477_: i32;
var phi_2480_: f32;
var phi_3032_: f32;
var phi_2340_: u32;
var phi_2343_: f32;
var phi_3034_: f32;
var phi_3749_: u32;
var phi_3803_: u32;
var phi_3867_: u32;
var phi_3921_: u32;
var phi_3985_: u32;
var phi_4039_: u32;
var phi_4109_: u32;
var phi_4112_: u32;
var phi_4110_: u32;
var phi_4113_: u32;
var local_16: u32;
var phi_4136_: u32;
var phi_4139_: u32;
var phi_4137_: u32;
var phi_4140_: u32;
var local_17: u32;
var phi_4831_: u32;
var phi_4834_: u32;
var phi_4832_: u32;
var phi_4835_: u32;
var local_18: u32;
var phi_4923_: u32;
var phi_4977_: u32;
var phi_5041_: u32;
var phi_5095_: u32;
var phi_5159_: u32;
var phi_5213_: u32;
var phi_5274_: i32;
var phi_5317_: i32;
var phi_5331_: u32;
var phi_5334_: f32;
var phi_5371_: u32;
var phi_5372_: u32;
var phi_5403_: i32;
var phi_5404_: i32;
var phi_5468_: i32;
var phi_5471_: f32;
var phi_5503_: i32;
var phi_5514_: i32;
var phi_5599_: u32;
var phi_5602_: u32;
var phi_5600_: u32;
var phi_5603_: u32;
var local_19: u32;
var phi_6012_: u32;
var phi_6022_: f32;
var phi_5469_: i32;
var phi_5472_: f32;
var phi_6024_: f32;
var phi_5332_: u32;
var phi_5335_: f32;
var local_20: f32;
var local_21: f32;
var phi_6750_: u32;
var phi_6804_: u32;
var phi_6868_: u32;
var phi_6922_: u32;
var phi_6986_: u32;
var phi_7040_: u32;
var phi_5318_: i32;
var phi_5275_: i32;
var phi_2323_: i32;
var phi_2220_: i32;
var local_22: u32;
var local_23: u32;
var local_24: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var local_28: f32;
var local_29: f32;
var local_30: f32;
let _e88 = global;
let _e95 = arrayLength((&global_3.member));
let _e98 = arrayLength((&global_4.member));
let _e100 = arrayLength((&global_5.member));
let _e103 = global_1.member.member;
if (_e88.x < _e103.member) {
if (_e88.y < _e103.member_1) {
let _e113 = global_1.member.member.member_1;
let _e114 = bitcast<i32>(_e113);
let _e118 = global_1.member.member_12.member_4;
let _e122 = global_1.member.member_12.member_5;
let _e124 = bitcast<i32>((_e118 * _e122));
let _e125 = bitcast<i32>(_e88.y);
local_9 = _e124;
local_10 = _e125;
local_11 = _e114;
let _e126 = local_9;
let _e127 = local_11;
let _e130 = local_10;
let _e131 = ((_e126 + (18i * _e127)) + _e130);
let _e133 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e135 = select(_e133, _e131, (_e131 < _e133));
let _e140 = global_2.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e141 = local_9;
let _e142 = local_11;
let _e145 = local_10;
let _e146 = ((_e141 + (19i * _e142)) + _e145);
let _e148 = select(_e133, _e146, (_e146 < _e133));
let _e153 = global_2.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e155 = local_9;
let _e156 = local_11;
let _e159 = local_10;
let _e160 = ((_e155 + (20i * _e156)) + _e159);
let _e162 = select(_e133, _e160, (_e160 < _e133));
let _e167 = global_2.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
if (((_e140 + _e153) + _e167) > 0f) {
local_6 = _e124;
local_7 = _e125;
local_8 = _e114;
let _e170 = local_6;
let _e171 = local_7;
let _e172 = (_e170 + _e171);
let _e174 = select(_e133, _e172, (_e172 < _e133));
let _e179 = global_2.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e180 = local_6;
let _e181 = local_8;
let _e183 = local_7;
let _e184 = ((_e180 + _e181) + _e183);
let _e186 = select(_e133, _e184, (_e184 < _e133));
let _e191 = global_2.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e192 = local_6;
let _e193 = local_8;
let _e196 = local_7;
let _e197 = ((_e192 + (2i * _e193)) + _e196);
let _e199 = select(_e133, _e197, (_e197 < _e133));
let _e204 = global_2.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e205 = local_6;
let _e206 = local_8;
let _e209 = local_7;
let _e210 = ((_e205 + (3i * _e206)) + _e209);
let _e212 = select(_e133, _e210, (_e210 < _e133));
let _e217 = global_2.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e218 = local_6;
let _e219 = local_8;
let _e222 = local_7;
let _e223 = ((_e218 + (4i * _e219)) + _e222);
let _e225 = select(_e133, _e223, (_e223 < _e133));
let _e230 = global_2.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e231 = local_6;
let _e232 = local_8;
let _e235 = local_7;
let _e236 = ((_e231 + (5i * _e232)) + _e235);
let _e238 = select(_e133, _e236, (_e236 < _e133));
let _e243 = global_2.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e244 = local_6;
let _e245 = local_8;
let _e248 = local_7;
let _e249 = ((_e244 + (6i * _e245)) + _e248);
let _e251 = select(_e133, _e249, (_e249 < _e133));
let _e256 = global_2.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e257 = local_6;
let _e258 = local_8;
let _e261 = local_7;
let _e262 = ((_e257 + (7i * _e258)) + _e261);
let _e264 = select(_e133, _e262, (_e262 < _e133));
let _e269 = global_2.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e270 = local_6;
let _e271 = local_8;
let _e274 = local_7;
let _e275 = ((_e270 + (8i * _e271)) + _e274);
let _e277 = select(_e133, _e275, (_e275 < _e133));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e283 = local_6;
let _e284 = local_8;
let _e287 = local_7;
let _e288 = ((_e283 + (9i * _e284)) + _e287);
let _e290 = select(_e133, _e288, (_e288 < _e133));
let _e295 = global_2.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e296 = local_6;
let _e297 = local_8;
let _e300 = local_7;
let _e301 = ((_e296 + (10i * _e297)) + _e300);
let _e303 = select(_e133, _e301, (_e301 < _e133));
let _e308 = global_2.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e309 = local_6;
let _e310 = local_8;
let _e313 = local_7;
let _e314 = ((_e309 + (11i * _e310)) + _e313);
let _e316 = select(_e133, _e314, (_e314 < _e133));
let _e321 = global_2.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e322 = local_6;
let _e323 = local_8;
let _e326 = local_7;
let _e327 = ((_e322 + (12i * _e323)) + _e326);
let _e329 = select(_e133, _e327, (_e327 < _e133));
let _e334 = global_2.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e335 = local_6;
let _e336 = local_8;
let _e339 = local_7;
let _e340 = ((_e335 + (13i * _e336)) + _e339);
let _e342 = select(_e133, _e340, (_e340 < _e133));
let _e347 = global_2.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e348 = local_6;
let _e349 = local_8;
let _e352 = local_7;
let _e353 = ((_e348 + (14i * _e349)) + _e352);
let _e355 = select(_e133, _e353, (_e353 < _e133));
let _e360 = global_2.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e361 = local_6;
let _e362 = local_8;
let _e365 = local_7;
let _e366 = ((_e361 + (15i * _e362)) + _e365);
let _e368 = select(_e133, _e366, (_e366 < _e133));
let _e373 = global_2.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e374 = local_6;
let _e375 = local_8;
let _e378 = local_7;
let _e379 = ((_e374 + (16i * _e375)) + _e378);
let _e381 = select(_e133, _e379, (_e379 < _e133));
let _e386 = global_2.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e387 = local_6;
let _e388 = local_8;
let _e391 = local_7;
let _e392 = ((_e387 + (17i * _e388)) + _e391);
let _e394 = select(_e133, _e392, (_e392 < _e133));
let _e399 = global_2.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e400 = local_6;
let _e401 = local_8;
let _e404 = local_7;
let _e405 = ((_e400 + (18i * _e401)) + _e404);
let _e407 = select(_e133, _e405, (_e405 < _e133));
let _e412 = global_2.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e413 = local_6;
let _e414 = local_8;
let _e417 = local_7;
let _e418 = ((_e413 + (19i * _e414)) + _e417);
let _e420 = select(_e133, _e418, (_e418 < _e133));
let _e425 = global_2.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e426 = local_6;
let _e427 = local_8;
let _e430 = local_7;
let _e431 = ((_e426 + (20i * _e427)) + _e430);
let _e433 = select(_e133, _e431, (_e431 < _e133));
let _e438 = global_2.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e439 = local_6;
let _e440 = local_8;
let _e443 = local_7;
let _e444 = ((_e439 + (23i * _e440)) + _e443);
let _e446 = select(_e133, _e444, (_e444 < _e133));
let _e451 = global_2.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e454 = global_1.member.member_6;
let _e458 = (_e179 - _e454.member);
let _e459 = (_e191 - _e454.member_1);
let _e460 = (_e204 - _e454.member_2);
let _e463 = ((_e459 * _e243) - (_e460 * _e230));
let _e466 = ((_e460 * _e217) - (_e458 * _e243));
let _e469 = ((_e458 * _e230) - (_e459 * _e217));
let _e472 = global_1.member.member_3;
let _e478 = global_1.member.member_4;
let _e484 = global_1.member.member_5;
let _e491 = global_1.member.member_2.member_3;
let _e492 = (_e491 != 0u);
let _e495 = ((_e484.member_1 * _e472.member_2) - (_e484.member_2 * _e472.member_1));
let _e498 = ((_e484.member_2 * _e472.member) - (_e484.member * _e472.member_2));
let _e501 = ((_e484.member * _e472.member_1) - (_e484.member_1 * _e472.member));
let _e513 = select((((_e472.member * _e463) + (_e472.member_1 * _e466)) + (_e472.member_2 * _e469)), -((((_e495 * _e217) + (_e498 * _e230)) + (_e501 * _e243))), _e492);
let _e516 = ((_e484.member_1 * _e478.member_2) - (_e484.member_2 * _e478.member_1));
let _e519 = ((_e484.member_2 * _e478.member) - (_e484.member * _e478.member_2));
let _e522 = ((_e484.member * _e478.member_1) - (_e484.member_1 * _e478.member));
let _e534 = select((((_e478.member * _e463) + (_e478.member_1 * _e466)) + (_e478.member_2 * _e469)), -((((_e516 * _e217) + (_e519 * _e230)) + (_e522 * _e243))), _e492);
let _e543 = global_1.member.member_1.member;
let _e544 = bitcast<i32>(_e543);
let _e545 = f32(_e544);
let _e549 = global_1.member.member_1.member_1;
let _e551 = f32(bitcast<i32>(_e549));
let _e555 = global_1.member.member_2.member;
let _e559 = global_1.member.member_2.member_1;
let _e561 = ((2f * _e555) / _e545);
let _e562 = (_e513 * _e561);
let _e564 = ((-2f * _e559) / _e551);
let _e565 = (_e534 * _e564);
let _e567 = ((_e555 / _e545) - _e555);
let _e571 = (_e559 - (_e559 / _e551));
let _e573 = (((((_e484.member * _e463) + (_e484.member_1 * _e466)) + (_e484.member_2 * _e469)) + (_e513 * _e567)) + (_e534 * _e571));
let _e592 = (((_e269 * _e243) - (_e282 * _e230)) + ((_e459 * _e360) - (_e460 * _e347)));
let _e593 = (((_e282 * _e217) - (_e256 * _e243)) + ((_e460 * _e334) - (_e458 * _e360)));
let _e594 = (((_e256 * _e230) - (_e269 * _e217)) + ((_e458 * _e347) - (_e459 * _e334)));
let _e606 = select((((_e472.member * _e592) + (_e472.member_1 * _e593)) + (_e472.member_2 * _e594)), -((((_e495 * _e334) + (_e498 * _e347)) + (_e501 * _e360))), _e492);
let _e618 = select((((_e478.member * _e592) + (_e478.member_1 * _e593)) + (_e478.member_2 * _e594)), -((((_e516 * _e334) + (_e519 * _e347)) + (_e522 * _e360))), _e492);
let _e624 = (_e606 * _e561);
let _e625 = (_e618 * _e564);
let _e629 = (((((_e484.member * _e592) + (_e484.member_1 * _e593)) + (_e484.member_2 * _e594)) + (_e606 * _e567)) + (_e618 * _e571));
let _e648 = (((_e308 * _e243) - (_e321 * _e230)) + ((_e459 * _e399) - (_e460 * _e386)));
let _e649 = (((_e321 * _e217) - (_e295 * _e243)) + ((_e460 * _e373) - (_e458 * _e399)));
let _e650 = (((_e295 * _e230) - (_e308 * _e217)) + ((_e458 * _e386) - (_e459 * _e373)));
let _e662 = select((((_e472.member * _e648) + (_e472.member_1 * _e649)) + (_e472.member_2 * _e650)), -((((_e495 * _e373) + (_e498 * _e386)) + (_e501 * _e399))), _e492);
let _e674 = select((((_e478.member * _e648) + (_e478.member_1 * _e649)) + (_e478.member_2 * _e650)), -((((_e516 * _e373) + (_e519 * _e386)) + (_e522 * _e399))), _e492);
let _e680 = (_e662 * _e561);
let _e681 = (_e674 * _e564);
let _e685 = (((((_e484.member * _e648) + (_e484.member_1 * _e649)) + (_e484.member_2 * _e650)) + (_e662 * _e567)) + (_e674 * _e571));
let _e692 = (bitcast<f32>((bitcast<u32>(_e562) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e565) & 2147483647u)));
let _e693 = select(_e562, _e565, _e692);
let _e694 = select(_e565, _e562, _e692);
let _e695 = select(_e624, _e625, _e692);
let _e696 = select(_e625, _e624, _e692);
let _e697 = select(_e680, _e681, _e692);
let _e698 = select(_e681, _e680, _e692);
let _e701 = bitcast<f32>((bitcast<u32>(_e694) & 2147483647u));
let _e707 = ((((_e484.member * _e458) + (_e484.member_1 * _e459)) + (_e484.member_2 * _e460)) - 1e-3f);
let _e712 = (((_e484.member * _e217) + (_e484.member_1 * _e230)) + (_e484.member_2 * _e243));
if (_e491 == 0u) {
let _e715 = (_e712 == 0f);
let _e717 = (-(_e707) / select(_e712, 1e-30f, _e715));
phi_1508_ = type_22(select(0f, select(0f, _e717, (_e717 > 0f)), (_e712 > 0f)), select(select(_e451, select(_e451, _e717, (_e717 < _e451)), (_e712 < 0f)), -1f, (_e715 && (_e707 < 0f))));
} else {
phi_1508_ = type_22(0f, _e451);
}
let _e732 = phi_1508_;
if ((_e701 <= 0f) || (_e732.member_1 <= _e732.member)) {
} else {
let _e744 = ((_e179 + (_e217 * _e732.member)) - _e454.member);
let _e745 = ((_e191 + (_e230 * _e732.member)) - _e454.member_1);
let _e746 = ((_e204 + (_e243 * _e732.member)) - _e454.member_2);
let _e751 = (((_e484.member * _e744) + (_e484.member_1 * _e745)) + (_e484.member_2 * _e746));
let _e755 = select((1f / select(1e-3f, _e751, (_e751 > 1e-3f))), 1f, _e492);
let _e764 = (0.5f * _e545);
let _e766 = ((((((((_e472.member * _e744) + (_e472.member_1 * _e745)) + (_e472.member_2 * _e746)) * _e755) / _e555) + 1f) * _e764) - 0.5f);
let _e775 = (0.5f * _e551);
let _e777 = (((1f - (((((_e478.member * _e744) + (_e478.member_1 * _e745)) + (_e478.member_2 * _e746)) * _e755) / _e559)) * _e775) - 0.5f);
let _e778 = -(1e6f);
let _e780 = select(_e778, _e766, (_e766 > _e778));
let _e782 = select(1e6f, _e780, (_e780 < 1e6f));
let _e784 = select(_e778, _e777, (_e777 > _e778));
let _e786 = select(1e6f, _e784, (_e784 < 1e6f));
let _e787 = select(_e782, _e786, _e692);
let _e788 = select(_e786, _e782, _e692);
let _e806 = (bitcast<f32>((bitcast<u32>(_e693) & 2147483647u)) / _e701);
let _e810 = (0.5f * 1f);
let _e812 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e695 * _e787) + ((_e696 * _e788) + _e629))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e697 * _e787) + ((_e698 * _e788) + _e685))) & 2147483647u)))) / _e701) + _e810) * _e806);
let _e815 = (select(1e6f, _e812, (_e812 < 1e6f)) + 1f);
let _e822 = ((_e179 + (_e217 * _e732.member_1)) - _e454.member);
let _e823 = ((_e191 + (_e230 * _e732.member_1)) - _e454.member_1);
let _e824 = ((_e204 + (_e243 * _e732.member_1)) - _e454.member_2);
let _e829 = (((_e484.member * _e822) + (_e484.member_1 * _e823)) + (_e484.member_2 * _e824));
let _e833 = select((1f / select(1e-3f, _e829, (_e829 > 1e-3f))), 1f, _e492);
let _e843 = ((((((((_e472.member * _e822) + (_e472.member_1 * _e823)) + (_e472.member_2 * _e824)) * _e833) / _e555) + 1f) * _e764) - 0.5f);
let _e853 = (((1f - (((((_e478.member * _e822) + (_e478.member_1 * _e823)) + (_e478.member_2 * _e824)) * _e833) / _e559)) * _e775) - 0.5f);
let _e855 = select(_e778, _e843, (_e843 > _e778));
let _e857 = select(1e6f, _e855, (_e855 < 1e6f));
let _e859 = select(_e778, _e853, (_e853 > _e778));
let _e861 = select(1e6f, _e859, (_e859 < 1e6f));
let _e862 = select(_e857, _e861, _e692);
let _e863 = select(_e861, _e857, _e692);
let _e882 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e695 * _e862) + ((_e696 * _e863) + _e629))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e697 * _e862) + ((_e698 * _e863) + _e685))) & 2147483647u)))) / _e701) + _e810) * _e806);
let _e885 = (select(1e6f, _e882, (_e882 < 1e6f)) + 1f);
let _e887 = bitcast<i32>(select(_e543, _e549, _e692));
let _e891 = bitcast<i32>((_e88.x * 16u));
let _e892 = (_e891 + 16i);
let _e893 = (_e862 < _e787);
let _e894 = (_e787 - _e815);
let _e895 = (_e862 - _e885);
let _e897 = select(_e895, _e894, (_e894 < _e895));
let _e898 = (_e787 + _e815);
let _e899 = (_e862 + _e885);
let _e901 = select(_e899, _e898, (_e898 > _e899));
let _e902 = select(_e898, _e899, _e893);
let _e903 = select(_e895, _e894, _e893);
let _e904 = f32(_e891);
let _e906 = (_e891 + 15i);
let _e909 = ((_e901 < _e904) || (_e897 > f32(_e906)));
if _e909 {
} else {
let _e911 = (0.5f * (16f - 1f));
let _e912 = (_e904 + _e911);
let _e916 = (-(((_e693 * _e912) + _e573)) / _e694);
let _e935 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e695 * _e912) + ((_e696 * _e916) + _e629))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e697 * _e912) + ((_e698 * _e916) + _e685))) & 2147483647u)))) / _e701) + _e810));
let _e939 = global_1.member.member_18.member_1;
phi_1918_ = 8f;
phi_1921_ = 0u;
loop {
let _e941 = phi_1918_;
let _e943 = phi_1921_;
local_12 = _e943;
local_22 = _e943;
let _e946 = ((_e943 < _e939) && (_e935 >= _e941));
if _e946 {
phi_1919_ = (_e941 * 2f);
phi_1922_ = (_e943 + 1u);
} else {
phi_1919_ = f32();
phi_1922_ = u32();
}
let _e950 = phi_1919_;
let _e952 = phi_1922_;
continue;
continuing {
phi_1918_ = _e950;
phi_1921_ = _e952;
break if !(_e946);
}
}
let _e955 = local_12;
let _e959 = f32((1i << bitcast<u32>((_e955 & 31u))));
let _e962 = f32(_e892);
if (((_e904 - _e959) > _e902) && ((_e962 + _e959) < _e903)) {
let _e3978 = local_22;
phi_1966_ = _e3978;
} else {
phi_1951_ = 8f;
phi_1954_ = 0u;
loop {
let _e968 = phi_1951_;
let _e970 = phi_1954_;
local_23 = _e970;
let _e973 = ((_e970 < _e939) && ((_e935 * 0.125f) >= _e968));
if _e973 {
phi_1952_ = (_e968 * 2f);
phi_1955_ = (_e970 + 1u);
} else {
phi_1952_ = f32();
phi_1955_ = u32();
}
let _e977 = phi_1952_;
let _e979 = phi_1955_;
continue;
continuing {
phi_1951_ = _e977;
phi_1954_ = _e979;
break if !(_e973);
}
}
let _e3980 = local_23;
phi_1966_ = _e3980;
}
let _e982 = phi_1966_;
let _e983 = select(_e982, 0u, _e909);
if (_e891 > 0i) {
let _e986 = f32((_e891 - 16i));
let _e987 = (_e986 + _e911);
let _e991 = (-(((_e693 * _e987) + _e573)) / _e694);
let _e1010 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e695 * _e987) + ((_e696 * _e991) + _e629))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e697 * _e987) + ((_e698 * _e991) + _e685))) & 2147483647u)))) / _e701) + _e810));
phi_2018_ = 8f;
phi_2021_ = 0u;
loop {
let _e1012 = phi_2018_;
let _e1014 = phi_2021_;
local_13 = _e1014;
local_24 = _e1014;
let _e1017 = ((_e1014 < _e939) && (_e1010 >= _e1012));
if _e1017 {
phi_2019_ = (_e1012 * 2f);
phi_2022_ = (_e1014 + 1u);
} else {
phi_2019_ = f32();
phi_2022_ = u32();
}
let _e1021 = phi_2019_;
let _e1023 = phi_2022_;
continue;
continuing {
phi_2018_ = _e1021;
phi_2021_ = _e1023;
break if !(_e1017);
}
}
let _e1026 = local_13;
let _e1030 = f32((1i << bitcast<u32>((_e1026 & 31u))));
if (((_e986 - _e1030) > _e902) && ((_e904 + _e1030) < _e903)) {
let _e3992 = local_24;
phi_2066_ = _e3992;
} else {
phi_2051_ = 8f;
phi_2054_ = 0u;
loop {
let _e1038 = phi_2051_;
let _e1040 = phi_2054_;
local_25 = _e1040;
let _e1043 = ((_e1040 < _e939) && ((_e1010 * 0.125f) >= _e1038));
if _e1043 {
phi_2052_ = (_e1038 * 2f);
phi_2055_ = (_e1040 + 1u);
} else {
phi_2052_ = f32();
phi_2055_ = u32();
}
let _e1047 = phi_2052_;
let _e1049 = phi_2055_;
continue;
continuing {
phi_2051_ = _e1047;
phi_2054_ = _e1049;
break if !(_e1043);
}
}
let _e3994 = local_25;
phi_2066_ = _e3994;
}
let _e1052 = phi_2066_;
phi_2077_ = select(_e1052, _e983, ((_e901 < _e986) || (_e897 > f32((_e891 - 1i)))));
} else {
phi_2077_ = _e983;
}
let _e1060 = phi_2077_;
let _e1061 = (_e892 < _e887);
if _e1061 {
let _e1063 = (_e962 + _e911);
let _e1067 = (-(((_e693 * _e1063) + _e573)) / _e694);
let _e1086 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e695 * _e1063) + ((_e696 * _e1067) + _e629))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e697 * _e1063) + ((_e698 * _e1067) + _e685))) & 2147483647u)))) / _e701) + _e810));
phi_2117_ = 8f;
phi_2120_ = 0u;
loop {
let _e1088 = phi_2117_;
let _e1090 = phi_2120_;
local_14 = _e1090;
local_26 = _e1090;
let _e1093 = ((_e1090 < _e939) && (_e1086 >= _e1088));
if _e1093 {
phi_2118_ = (_e1088 * 2f);
phi_2121_ = (_e1090 + 1u);
} else {
phi_2118_ = f32();
phi_2121_ = u32();
}
let _e1097 = phi_2118_;
let _e1099 = phi_2121_;
continue;
continuing {
phi_2117_ = _e1097;
phi_2120_ = _e1099;
break if !(_e1093);
}
}
let _e1102 = local_14;
let _e1106 = f32((1i << bitcast<u32>((_e1102 & 31u))));
if (((_e962 - _e1106) > _e902) && ((f32((_e891 + 32i)) + _e1106) < _e903)) {
let _e4007 = local_26;
phi_2165_ = _e4007;
} else {
phi_2150_ = 8f;
phi_2153_ = 0u;
loop {
let _e1115 = phi_2150_;
let _e1117 = phi_2153_;
local_27 = _e1117;
let _e1120 = ((_e1117 < _e939) && ((_e1086 * 0.125f) >= _e1115));
if _e1120 {
phi_2151_ = (_e1115 * 2f);
phi_2154_ = (_e1117 + 1u);
} else {
phi_2151_ = f32();
phi_2154_ = u32();
}
let _e1124 = phi_2151_;
let _e1126 = phi_2154_;
continue;
continuing {
phi_2150_ = _e1124;
phi_2153_ = _e1126;
break if !(_e1120);
}
}
let _e4009 = local_27;
phi_2165_ = _e4009;
}
let _e1129 = phi_2165_;
phi_2176_ = select(_e1129, _e983, ((_e901 < _e962) || (_e897 > f32((_e891 + 31i)))));
} else {
phi_2176_ = _e983;
}
let _e1137 = phi_2176_;
let _e1138 = (_e983 & 31u);
let _e1140 = (1i << bitcast<u32>(_e1138));
let _e1141 = f32(_e1140);
let _e1143 = select(_e904, _e897, (_e897 > _e904));
let _e1160 = f32(((bitcast<i32>(select(_e549, _e543, _e692)) - 1i) >> bitcast<u32>(_e1138)));
phi_2219_ = (select(0i, select(select(i32(_e1143), i32(-2147483648), (_e1143 < -2147483600f)), 2147483647i, (_e1143 > 2147483500f)), (_e1143 == _e1143)) >> bitcast<u32>(_e1138));
loop {
let _e1162 = phi_2219_;
let _e1163 = (_e1162 <= ((select(_e887, _e892, _e1061) - 1i) >> bitcast<u32>(_e1138)));
if _e1163 {
let _e1165 = (f32(_e1162) + 0.5f);
let _e1167 = ((_e1165 * _e1141) - 0.5f);
let _e1171 = (-(((_e693 * _e1167) + _e573)) / _e694);
let _e1178 = bitcast<f32>((bitcast<u32>(((_e695 * _e1167) + ((_e696 * _e1171) + _e629))) & 2147483647u));
let _e1185 = bitcast<f32>((bitcast<u32>(((_e697 * _e1167) + ((_e698 * _e1171) + _e685))) & 2147483647u));
let _e1190 = (((0.5f * (_e1178 + _e1185)) / _e701) + (0.5f * _e1141));
let _e1198 = ((((_e1171 + _e1190) + 0.5f) / _e1141) - 0.5f);
let _e1199 = (((((_e1171 - _e1190) + 0.5f) / _e1141) - 0.5f) + 1f);
let _e1200 = (_e1160 + 1f);
let _e1202 = select(0f, _e1199, (_e1199 > 0f));
let _e1204 = select(_e1200, _e1202, (_e1202 < _e1200));
let _e1211 = select(0i, select(select(i32(_e1204), i32(-2147483648), (_e1204 < -2147483600f)), 2147483647i, (_e1204 > 2147483500f)), (_e1204 == _e1204));
let _e1217 = select(-1f, _e1198, (_e1198 > -1f));
let _e1219 = select(_e1160, _e1217, (_e1217 < _e1160));
let _e1226 = select(0i, select(select(i32(_e1219), i32(-2147483648), (_e1219 < -2147483600f)), 2147483647i, (_e1219 > 2147483500f)), (_e1219 == _e1219));
let _e1231 = (_e983 == 0u);
phi_2322_ = (_e1211 - select(0i, 1i, (_e1204 < f32(_e1211))));
loop {
let _e1251 = phi_2322_;
let _e1252 = (_e1251 <= (_e1226 - select(0i, 1i, (_e1219 < f32(_e1226)))));
if _e1252 {
if _e1231 {
if (_e1231 && (((_e1060 > 0u) && ((2i * (_e1162 - _e891)) < (1i << bitcast<u32>((_e1060 & 31u))))) || ((_e1137 > 0u) && ((2i * (_e906 - _e1162)) < (1i << bitcast<u32>((_e1137 & 31u))))))) {
phi_2339_ = 0u;
phi_2342_ = 1f;
loop {
let _e1254 = phi_2339_;
let _e1256 = phi_2342_;
local_29 = _e1256;
let _e1257 = (_e1254 < 3u);
if _e1257 {
if (_e1254 == 0u) {
phi_2380_ = _e983;
} else {
if (_e1254 == 1u) {
phi_2379_ = select(_e1060, 0u, (_e1060 == _e983));
} else {
phi_2379_ = select(_e1137, 0u, ((_e1137 == _e983) || (_e1137 == _e1060)));
}
let _e1267 = phi_2379_;
phi_2380_ = _e1267;
}
let _e1269 = phi_2380_;
if (_e1269 > 0u) {
let _e1273 = global_1.member.member_1.member;
let _e1276 = global_1.member.member_1.member_1;
let _e1277 = (_e1269 & 31u);
let _e1279 = (1u << bitcast<u32>(_e1277));
let _e1283 = (((_e1273 + _e1279) - 1u) >> bitcast<u32>(_e1277));
let _e1287 = (((_e1276 + _e1279) - 1u) >> bitcast<u32>(_e1277));
if _e692 {
phi_2411_ = bitcast<i32>(_e1283);
phi_2412_ = bitcast<i32>(_e1287);
} else {
phi_2411_ = bitcast<i32>(_e1287);
phi_2412_ = bitcast<i32>(_e1283);
}
let _e1293 = phi_2411_;
let _e1295 = phi_2412_;
let _e1298 = f32((1i << bitcast<u32>(_e1277)));
let _e1299 = (1f / _e1298);
let _e1301 = ((_e1165 * _e1299) - 0.5f);
let _e1305 = (((f32(_e1251) + 0.5f) * _e1299) - 0.5f);
let _e1307 = select(-1f, _e1301, (_e1301 > -1f));
let _e1309 = select(1e6f, _e1307, (_e1307 < 1e6f));
let _e1316 = select(0i, select(select(i32(_e1309), i32(-2147483648), (_e1309 < -2147483600f)), 2147483647i, (_e1309 > 2147483500f)), (_e1309 == _e1309));
let _e1320 = (_e1316 - select(0i, 1i, (_e1309 < f32(_e1316))));
let _e1322 = select(-1f, _e1305, (_e1305 > -1f));
let _e1324 = select(1e6f, _e1322, (_e1322 < 1e6f));
let _e1331 = select(0i, select(select(i32(_e1324), i32(-2147483648), (_e1324 < -2147483600f)), 2147483647i, (_e1324 > 2147483500f)), (_e1324 == _e1324));
let _e1335 = (_e1331 - select(0i, 1i, (_e1324 < f32(_e1331))));
let _e1337 = (_e1301 - f32(_e1320));
let _e1339 = (_e1305 - f32(_e1335));
phi_2476_ = 0i;
phi_2479_ = _e1256;
loop {
let _e1341 = phi_2476_;
let _e1343 = phi_2479_;
local_28 = _e1343;
let _e1344 = (_e1341 < 4i);
if _e1344 {
let _e1345 = (_e1341 & 1i);
let _e1346 = (_e1320 + _e1345);
let _e1348 = (_e1341 >> bitcast<u32>(1i));
let _e1349 = (_e1335 + _e1348);
if (_e1346 < _e1295) {
phi_2511_ = _e1346;
} else {
phi_2511_ = (_e1295 - 1i);
}
let _e1360 = phi_2511_;
let _e1362 = select(0i, _e1360, (_e1360 > 0i));
if (_e1349 < _e1293) {
phi_2522_ = _e1349;
} else {
phi_2522_ = (_e1293 - 1i);
}
let _e1366 = phi_2522_;
let _e1368 = select(0i, _e1366, (_e1366 > 0i));
let _e1372 = (((f32(_e1362) + 0.5f) * _e1298) - 0.5f);
let _e1376 = (((f32(_e1368) + 0.5f) * _e1298) - 0.5f);
phi_2607_ = 1u;
phi_2610_ = 0u;
loop {
let _e1386 = phi_2607_;
let _e1388 = phi_2610_;
local_15 = _e1388;
let _e1389 = (_e1386 < _e1269);
if _e1389 {
let _e1390 = (_e1386 & 31u);
phi_2608_ = (_e1386 + 1u);
phi_2611_ = (_e1388 + (((_e1276 + (1u << bitcast<u32>(_e1390))) - 1u) >> bitcast<u32>(_e1390)));
} else {
phi_2608_ = u32();
phi_2611_ = u32();
}
let _e1400 = phi_2608_;
let _e1402 = phi_2611_;
continue;
continuing {
phi_2607_ = _e1400;
phi_2610_ = _e1402;
break if !(_e1389);
}
}
let _e1405 = local_15;
local_4 = (((bitcast<i32>(_e1405) + select(_e1368, _e1362, _e692)) * bitcast<i32>(((_e1273 + 1u) >> bitcast<u32>(1u)))) + select(_e1362, _e1368, _e692));
let _e1410 = local_4;
let _e1412 = (bitcast<i32>(_e98) - 1i);
let _e1414 = select(_e1412, _e1410, (_e1410 < _e1412));
let _e1419 = global_4.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1430 = global_1.member.member_2.member;
let _e1431 = (((((select(_e1372, _e1376, _e692) + 0.5f) / f32(bitcast<i32>(_e1273))) * 2f) - 1f) * _e1430);
let _e1438 = global_1.member.member_2.member_1;
let _e1439 = ((1f - (((select(_e1376, _e1372, _e692) + 0.5f) / f32(bitcast<i32>(_e1276))) * 2f)) * _e1438);
let _e1441 = global_1.member.member_3;
let _e1449 = global_1.member.member_4;
let _e1456 = ((_e1441.member * _e1431) + (_e1449.member * _e1439));
let _e1457 = ((_e1441.member_1 * _e1431) + (_e1449.member_1 * _e1439));
let _e1458 = ((_e1441.member_2 * _e1431) + (_e1449.member_2 * _e1439));
let _e1461 = global_1.member.member_2.member_3;
let _e1462 = (_e1461 != 0u);
let _e1464 = global_1.member.member_5;
let _e1471 = select((_e1464.member + _e1456), _e1464.member, _e1462);
let _e1472 = select((_e1464.member_1 + _e1457), _e1464.member_1, _e1462);
let _e1473 = select((_e1464.member_2 + _e1458), _e1464.member_2, _e1462);
let _e1475 = global_1.member.member_6;
let _e1489 = (((_e1471 * _e1471) + (_e1472 * _e1472)) + (_e1473 * _e1473));
let _e1493 = (1f / sqrt(select(0f, _e1489, (_e1489 > 0f))));
let _e1494 = (_e1471 * _e1493);
let _e1495 = (_e1472 * _e1493);
let _e1496 = (_e1473 * _e1493);
let _e1497 = (_e179 - select(_e1475.member, (_e1475.member + _e1456), _e1462));
let _e1498 = (_e191 - select(_e1475.member_1, (_e1475.member_1 + _e1457), _e1462));
let _e1499 = (_e204 - select(_e1475.member_2, (_e1475.member_2 + _e1458), _e1462));
let _e1504 = (((_e1497 * _e1494) + (_e1498 * _e1495)) + (_e1499 * _e1496));
let _e1509 = (((_e1497 * _e217) + (_e1498 * _e230)) + (_e1499 * _e243));
let _e1514 = (((_e1494 * _e217) + (_e1495 * _e230)) + (_e1496 * _e243));
let _e1517 = ((_e1495 * _e243) - (_e1496 * _e230));
let _e1520 = ((_e1496 * _e217) - (_e1494 * _e243));
let _e1523 = ((_e1494 * _e230) - (_e1495 * _e217));
let _e1528 = (((_e1517 * _e1517) + (_e1520 * _e1520)) + (_e1523 * _e1523));
let _e1531 = (1f / select(1e-9f, _e1528, (_e1528 > 1e-9f)));
let _e1534 = ((_e1504 - (_e1514 * _e1509)) * _e1531);
let _e1537 = (((_e1514 * _e1504) - _e1509) * _e1531);
let _e1543 = select(0f, _e1534, (((_e1537 >= 0f) && (_e1537 < _e451)) && (_e1534 > 0f)));
let _e1545 = (_e1362 << bitcast<u32>(_e1277));
if (_e1545 < _e891) {
phi_3020_ = _e1060;
} else {
phi_3020_ = select(_e983, _e1137, (_e1545 >= _e892));
}
let _e1550 = phi_3020_;
if (((_e1550 == _e1269) && (_e1543 > 0f)) && (_e1543 < _e1419)) {
phi_3030_ = (_e1343 - (select((1f - _e1337), _e1337, (_e1345 == 1i)) * select((1f - _e1339), _e1339, (_e1348 == 1i))));
} else {
phi_3030_ = _e1343;
}
let _e1558 = phi_3030_;
phi_2477_ = (_e1341 + 1i);
phi_2480_ = _e1558;
} else {
phi_2477_ = i32();
phi_2480_ = f32();
}
let _e1561 = phi_2477_;
let _e1563 = phi_2480_;
continue;
continuing {
phi_2476_ = _e1561;
phi_2479_ = _e1563;
break if !(_e1344);
}
}
let _e4034 = local_28;
phi_3032_ = _e4034;
} else {
phi_3032_ = _e1256;
}
let _e1566 = phi_3032_;
phi_2340_ = (_e1254 + 1u);
phi_2343_ = _e1566;
} else {
phi_2340_ = u32();
phi_2343_ = f32();
}
let _e1569 = phi_2340_;
let _e1571 = phi_2343_;
continue;
continuing {
phi_2339_ = _e1569;
phi_2342_ = _e1571;
break if !(_e1257);
}
}
let _e4039 = local_29;
phi_3034_ = _e4039;
} else {
phi_3034_ = 1f;
}
let _e1574 = phi_3034_;
let _e1575 = select(_e1162, _e1251, _e692);
let _e1576 = select(_e1251, _e1162, _e692);
let _e1580 = ((_e1576 * _e544) + _e1575);
let _e1582 = (bitcast<i32>(_e95) - 1i);
let _e1584 = select(_e1582, _e1580, (_e1580 < _e1582));
let _e1590 = global_3.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1591 = (bitcast<i32>((_e543 * _e549)) + _e1580);
let _e1593 = select(_e1582, _e1591, (_e1591 < _e1582));
let _e1599 = global_3.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1606 = (((((f32(_e1575) + 0.5f) / _e545) * 2f) - 1f) * _e555);
let _e1611 = ((1f - (((f32(_e1576) + 0.5f) / _e551) * 2f)) * _e559);
let _e1618 = ((_e472.member * _e1606) + (_e478.member * _e1611));
let _e1619 = ((_e472.member_1 * _e1606) + (_e478.member_1 * _e1611));
let _e1620 = ((_e472.member_2 * _e1606) + (_e478.member_2 * _e1611));
let _e1624 = select((_e484.member + _e1618), _e484.member, _e492);
let _e1625 = select((_e484.member_1 + _e1619), _e484.member_1, _e492);
let _e1626 = select((_e484.member_2 + _e1620), _e484.member_2, _e492);
let _e1637 = (((_e1624 * _e1624) + (_e1625 * _e1625)) + (_e1626 * _e1626));
let _e1640 = sqrt(select(0f, _e1637, (_e1637 > 0f)));
let _e1641 = (1f / _e1640);
let _e1642 = (_e1624 * _e1641);
let _e1643 = (_e1625 * _e1641);
let _e1644 = (_e1626 * _e1641);
let _e1645 = (_e179 - select(_e454.member, (_e454.member + _e1618), _e492));
let _e1646 = (_e191 - select(_e454.member_1, (_e454.member_1 + _e1619), _e492));
let _e1647 = (_e204 - select(_e454.member_2, (_e454.member_2 + _e1620), _e492));
let _e1652 = (((_e1645 * _e1642) + (_e1646 * _e1643)) + (_e1647 * _e1644));
let _e1657 = (((_e1645 * _e217) + (_e1646 * _e230)) + (_e1647 * _e243));
let _e1662 = (((_e1642 * _e217) + (_e1643 * _e230)) + (_e1644 * _e243));
let _e1665 = ((_e1643 * _e243) - (_e1644 * _e230));
let _e1668 = ((_e1644 * _e217) - (_e1642 * _e243));
let _e1671 = ((_e1642 * _e230) - (_e1643 * _e217));
let _e1676 = (((_e1665 * _e1665) + (_e1668 * _e1668)) + (_e1671 * _e1671));
let _e1679 = (1f / select(1e-9f, _e1676, (_e1676 > 1e-9f)));
let _e1682 = ((_e1652 - (_e1662 * _e1657)) * _e1679);
let _e1685 = (((_e1662 * _e1652) - _e1657) * _e1679);
let _e1691 = (_e1682 - _e1599);
let _e1694 = (_e1685 + select(0f, _e1691, (_e1691 > 0f)));
let _e1698 = global_1.member.member_13.member;
let _e1703 = -((_e1698.member * _e1694));
let _e1705 = select(-87f, _e1703, (_e1703 > -87f));
let _e1707 = select(88f, _e1705, (_e1705 < 88f));
let _e1709 = ((_e1707 * 1.442695f) + 0.5f);
let _e1711 = select(-127f, _e1709, (_e1709 > -127f));
let _e1713 = select(128f, _e1711, (_e1711 < 128f));
let _e1720 = select(0i, select(select(i32(_e1713), i32(-2147483648), (_e1713 < -2147483600f)), 2147483647i, (_e1713 > 2147483500f)), (_e1713 == _e1713));
let _e1724 = (_e1720 - select(0i, 1i, (_e1713 < f32(_e1720))));
let _e1725 = f32(_e1724);
let _e1729 = ((_e1707 - (_e1725 * 0.6933594f)) - (_e1725 * -2.1219444e-4f));
let _e1751 = -((_e1698.member_1 * _e1694));
let _e1753 = select(-87f, _e1751, (_e1751 > -87f));
let _e1755 = select(88f, _e1753, (_e1753 < 88f));
let _e1757 = ((_e1755 * 1.442695f) + 0.5f);
let _e1759 = select(-127f, _e1757, (_e1757 > -127f));
let _e1761 = select(128f, _e1759, (_e1759 < 128f));
let _e1768 = select(0i, select(select(i32(_e1761), i32(-2147483648), (_e1761 < -2147483600f)), 2147483647i, (_e1761 > 2147483500f)), (_e1761 == _e1761));
let _e1772 = (_e1768 - select(0i, 1i, (_e1761 < f32(_e1768))));
let _e1773 = f32(_e1772);
let _e1777 = ((_e1755 - (_e1773 * 0.6933594f)) - (_e1773 * -2.1219444e-4f));
let _e1799 = -((_e1698.member_2 * _e1694));
let _e1801 = select(-87f, _e1799, (_e1799 > -87f));
let _e1803 = select(88f, _e1801, (_e1801 < 88f));
let _e1805 = ((_e1803 * 1.442695f) + 0.5f);
let _e1807 = select(-127f, _e1805, (_e1805 > -127f));
let _e1809 = select(128f, _e1807, (_e1807 < 128f));
let _e1816 = select(0i, select(select(i32(_e1809), i32(-2147483648), (_e1809 < -2147483600f)), 2147483647i, (_e1809 > 2147483500f)), (_e1809 == _e1809));
let _e1820 = (_e1816 - select(0i, 1i, (_e1809 < f32(_e1816))));
let _e1821 = f32(_e1820);
let _e1825 = ((_e1803 - (_e1821 * 0.6933594f)) - (_e1821 * -2.1219444e-4f));
let _e1846 = -(_e1662);
let _e1850 = global_1.member.member_13.member_2;
let _e1851 = (_e1850 * _e1850);
let _e1855 = ((1f + _e1851) - ((2f * _e1850) * _e1846));
let _e1857 = select(1e-9f, _e1855, (_e1855 > 1e-9f));
let _e1870 = global_1.member.member_13.member_3;
let _e1875 = (_e1640 * (select(((1f - _e1851) / (_e1857 * sqrt(select(0f, _e1857, (_e1857 > 0f))))), (0.75f * (1f + (_e1846 * _e1846))), (_e1870 == 1u)) * (0.25f / 3.1415927f)));
let _e1879 = global_1.member.member_13.member_1;
let _e1892 = select(0f, _e1682, (((_e1685 >= 0f) && (_e1685 < _e451)) && (_e1682 > 0f)));
if ((_e1892 > 0f) && (_e1892 < _e1590)) {
let _e1898 = ((f32(_e1251) - _e1171) * _e701);
let _e1899 = (_e701 * 1f);
let _e1900 = (1e-4f * _e1899);
let _e1902 = select(_e1185, _e1178, (_e1178 > _e1185));
let _e1904 = select(_e1900, _e1902, (_e1902 > _e1900));
let _e1906 = select(_e1185, _e1178, (_e1178 < _e1185));
let _e1908 = select(_e1900, _e1906, (_e1906 > _e1900));
let _e1909 = (0.5f * _e1899);
let _e1910 = (_e1898 + _e1909);
let _e1911 = -(_e1910);
let _e1915 = (0.5f * (_e1904 + _e1908));
let _e1916 = (_e1915 - select(_e1911, _e1910, (_e1910 > _e1911)));
let _e1918 = select(0f, _e1916, (_e1916 > 0f));
let _e1920 = select(_e1908, _e1918, (_e1918 < _e1908));
let _e1924 = (_e1916 - _e1908);
let _e1928 = ((((_e1920 * (_e1920 / _e1908)) * 0.5f) + select(0f, _e1924, (_e1924 > 0f))) / _e1904);
let _e1932 = (_e1898 - _e1909);
let _e1933 = -(_e1932);
let _e1936 = (_e1915 - select(_e1933, _e1932, (_e1932 > _e1933)));
let _e1938 = select(0f, _e1936, (_e1936 > 0f));
let _e1940 = select(_e1908, _e1938, (_e1938 < _e1908));
let _e1944 = (_e1936 - _e1908);
let _e1948 = ((((_e1940 * (_e1940 / _e1908)) * 0.5f) + select(0f, _e1944, (_e1944 > 0f))) / _e1904);
let _e1954 = (((select(_e1928, (1f - _e1928), (_e1910 >= 0f)) - select(_e1948, (1f - _e1948), (_e1932 >= 0f))) / _e1899) * _e1574);
let _e1958 = (_e1580 * 6i);
let _e1962 = global_1.member.member_18.member;
let _e1963 = (((((_e412 * _e1879.member) * ((1f + (_e1729 * (1f + (_e1729 * (0.5f + (_e1729 * (0.16666667f + (_e1729 * (0.041666668f + (_e1729 * (0.008333334f + (_e1729 * (0.001388889f + (_e1729 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1724 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
if (bitcast<f32>((bitcast<u32>(_e1963) & 2147483647u)) < 1073741800f) {
let _e1969 = ((_e1963 * 1f) + 0.5f);
let _e1971 = select(-1073741800f, _e1969, (_e1969 > -1073741800f));
let _e1973 = select(1073741800f, _e1971, (_e1971 < 1073741800f));
let _e1980 = select(0i, select(select(i32(_e1973), i32(-2147483648), (_e1973 < -2147483600f)), 2147483647i, (_e1973 > 2147483500f)), (_e1973 == _e1973));
let _e1984 = (_e1980 - select(0i, 1i, (_e1973 < f32(_e1980))));
if (_e1984 == 0i) {
} else {
let _e1986 = bitcast<u32>(_e1984);
let _e1987 = bitcast<u32>(_e1958);
if (_e1987 < _e100) {
let _e1991 = atomicAdd((&global_5.member[_e1987]), _e1986);
phi_3749_ = _e1991;
} else {
phi_3749_ = 0u;
}
let _e1993 = phi_3749_;
let _e2000 = (bitcast<u32>((_e1984 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1993 + _e1986) < _e1986)));
if (_e2000 == 0u) {
} else {
let _e2002 = (_e1987 + 1u);
if (_e2002 < _e100) {
let _e2006 = atomicAdd((&global_5.member[_e2002]), _e2000);
}
}
}
} else {
let _e2009 = ((_e1963 * (1f / 1048576f)) + 0.5f);
let _e2011 = select(-1073741800f, _e2009, (_e2009 > -1073741800f));
let _e2013 = select(1073741800f, _e2011, (_e2011 < 1073741800f));
let _e2020 = select(0i, select(select(i32(_e2013), i32(-2147483648), (_e2013 < -2147483600f)), 2147483647i, (_e2013 > 2147483500f)), (_e2013 == _e2013));
let _e2024 = (_e2020 - select(0i, 1i, (_e2013 < f32(_e2020))));
let _e2027 = (bitcast<u32>(_e2024) << bitcast<u32>(20i));
let _e2028 = bitcast<u32>(_e1958);
if (_e2028 < _e100) {
let _e2032 = atomicAdd((&global_5.member[_e2028]), _e2027);
phi_3803_ = _e2032;
} else {
phi_3803_ = 0u;
}
let _e2034 = phi_3803_;
let _e2038 = (_e2028 + 1u);
if (_e2038 < _e100) {
let _e2046 = atomicAdd((&global_5.member[_e2038]), (bitcast<u32>((_e2024 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2034 + _e2027) < _e2027))));
}
}
let _e2047 = (_e1958 + 2i);
let _e2048 = (((((_e425 * _e1879.member_1) * ((1f + (_e1777 * (1f + (_e1777 * (0.5f + (_e1777 * (0.16666667f + (_e1777 * (0.041666668f + (_e1777 * (0.008333334f + (_e1777 * (0.001388889f + (_e1777 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1772 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
if (bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u)) < 1073741800f) {
let _e2054 = ((_e2048 * 1f) + 0.5f);
let _e2056 = select(-1073741800f, _e2054, (_e2054 > -1073741800f));
let _e2058 = select(1073741800f, _e2056, (_e2056 < 1073741800f));
let _e2065 = select(0i, select(select(i32(_e2058), i32(-2147483648), (_e2058 < -2147483600f)), 2147483647i, (_e2058 > 2147483500f)), (_e2058 == _e2058));
let _e2069 = (_e2065 - select(0i, 1i, (_e2058 < f32(_e2065))));
if (_e2069 == 0i) {
} else {
let _e2071 = bitcast<u32>(_e2069);
let _e2072 = bitcast<u32>(_e2047);
if (_e2072 < _e100) {
let _e2076 = atomicAdd((&global_5.member[_e2072]), _e2071);
phi_3867_ = _e2076;
} else {
phi_3867_ = 0u;
}
let _e2078 = phi_3867_;
let _e2085 = (bitcast<u32>((_e2069 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2078 + _e2071) < _e2071)));
if (_e2085 == 0u) {
} else {
let _e2087 = (_e2072 + 1u);
if (_e2087 < _e100) {
let _e2091 = atomicAdd((&global_5.member[_e2087]), _e2085);
}
}
}
} else {
let _e2094 = ((_e2048 * (1f / 1048576f)) + 0.5f);
let _e2096 = select(-1073741800f, _e2094, (_e2094 > -1073741800f));
let _e2098 = select(1073741800f, _e2096, (_e2096 < 1073741800f));
let _e2105 = select(0i, select(select(i32(_e2098), i32(-2147483648), (_e2098 < -2147483600f)), 2147483647i, (_e2098 > 2147483500f)), (_e2098 == _e2098));
let _e2109 = (_e2105 - select(0i, 1i, (_e2098 < f32(_e2105))));
let _e2112 = (bitcast<u32>(_e2109) << bitcast<u32>(20i));
let _e2113 = bitcast<u32>(_e2047);
if (_e2113 < _e100) {
let _e2117 = atomicAdd((&global_5.member[_e2113]), _e2112);
phi_3921_ = _e2117;
} else {
phi_3921_ = 0u;
}
let _e2119 = phi_3921_;
let _e2123 = (_e2113 + 1u);
if (_e2123 < _e100) {
let _e2131 = atomicAdd((&global_5.member[_e2123]), (bitcast<u32>((_e2109 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2119 + _e2112) < _e2112))));
}
}
let _e2132 = (_e1958 + 4i);
let _e2133 = (((((_e438 * _e1879.member_2) * ((1f + (_e1825 * (1f + (_e1825 * (0.5f + (_e1825 * (0.16666667f + (_e1825 * (0.041666668f + (_e1825 * (0.008333334f + (_e1825 * (0.001388889f + (_e1825 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1820 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
if (bitcast<f32>((bitcast<u32>(_e2133) & 2147483647u)) < 1073741800f) {
let _e2139 = ((_e2133 * 1f) + 0.5f);
let _e2141 = select(-1073741800f, _e2139, (_e2139 > -1073741800f));
let _e2143 = select(1073741800f, _e2141, (_e2141 < 1073741800f));
let _e2150 = select(0i, select(select(i32(_e2143), i32(-2147483648), (_e2143 < -2147483600f)), 2147483647i, (_e2143 > 2147483500f)), (_e2143 == _e2143));
let _e2154 = (_e2150 - select(0i, 1i, (_e2143 < f32(_e2150))));
if (_e2154 == 0i) {
} else {
let _e2156 = bitcast<u32>(_e2154);
let _e2157 = bitcast<u32>(_e2132);
if (_e2157 < _e100) {
let _e2161 = atomicAdd((&global_5.member[_e2157]), _e2156);
phi_3985_ = _e2161;
} else {
phi_3985_ = 0u;
}
let _e2163 = phi_3985_;
let _e2170 = (bitcast<u32>((_e2154 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2163 + _e2156) < _e2156)));
if (_e2170 == 0u) {
} else {
let _e2172 = (_e2157 + 1u);
if (_e2172 < _e100) {
let _e2176 = atomicAdd((&global_5.member[_e2172]), _e2170);
}
}
}
} else {
let _e2179 = ((_e2133 * (1f / 1048576f)) + 0.5f);
let _e2181 = select(-1073741800f, _e2179, (_e2179 > -1073741800f));
let _e2183 = select(1073741800f, _e2181, (_e2181 < 1073741800f));
let _e2190 = select(0i, select(select(i32(_e2183), i32(-2147483648), (_e2183 < -2147483600f)), 2147483647i, (_e2183 > 2147483500f)), (_e2183 == _e2183));
let _e2194 = (_e2190 - select(0i, 1i, (_e2183 < f32(_e2190))));
let _e2197 = (bitcast<u32>(_e2194) << bitcast<u32>(20i));
let _e2198 = bitcast<u32>(_e2132);
if (_e2198 < _e100) {
let _e2202 = atomicAdd((&global_5.member[_e2198]), _e2197);
phi_4039_ = _e2202;
} else {
phi_4039_ = 0u;
}
let _e2204 = phi_4039_;
let _e2208 = (_e2198 + 1u);
if (_e2208 < _e100) {
let _e2216 = atomicAdd((&global_5.member[_e2208]), (bitcast<u32>((_e2194 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2204 + _e2197) < _e2197))));
}
}
}
} else {
let _e2220 = (((f32(_e1251) + 0.5f) * _e1141) - 0.5f);
let _e2223 = select(_e1162, _e1251, _e692);
let _e2224 = select(_e1251, _e1162, _e692);
let _e2227 = global_1.member.member_1.member;
let _e2231 = bitcast<i32>(((_e2227 + 1u) >> bitcast<u32>(1u)));
let _e2234 = global_1.member.member_1.member_1;
let _e2237 = global_1.member.member_18.member_1;
phi_4109_ = 1u;
phi_4112_ = 0u;
loop {
let _e2240 = phi_4109_;
let _e2242 = phi_4112_;
local_16 = _e2242;
let _e2243 = (_e2240 < (_e2237 + 1u));
if _e2243 {
let _e2244 = (_e2240 & 31u);
phi_4110_ = (_e2240 + 1u);
phi_4113_ = (_e2242 + (((_e2234 + (1u << bitcast<u32>(_e2244))) - 1u) >> bitcast<u32>(_e2244)));
} else {
phi_4110_ = u32();
phi_4113_ = u32();
}
let _e2254 = phi_4110_;
let _e2256 = phi_4113_;
continue;
continuing {
phi_4109_ = _e2254;
phi_4112_ = _e2256;
break if !(_e2243);
}
}
let _e2259 = local_16;
phi_4136_ = 1u;
phi_4139_ = 0u;
loop {
let _e2263 = phi_4136_;
let _e2265 = phi_4139_;
local_17 = _e2265;
let _e2266 = (_e2263 < _e983);
if _e2266 {
let _e2267 = (_e2263 & 31u);
phi_4137_ = (_e2263 + 1u);
phi_4140_ = (_e2265 + (((_e2234 + (1u << bitcast<u32>(_e2267))) - 1u) >> bitcast<u32>(_e2267)));
} else {
phi_4137_ = u32();
phi_4140_ = u32();
}
let _e2277 = phi_4137_;
let _e2279 = phi_4140_;
continue;
continuing {
phi_4136_ = _e2277;
phi_4139_ = _e2279;
break if !(_e2266);
}
}
let _e2282 = local_17;
local_2 = (((bitcast<i32>(_e2282) + _e2224) * _e2231) + _e2223);
local_3 = (_e2231 * bitcast<i32>(_e2259));
let _e2287 = local_2;
let _e2289 = (bitcast<i32>(_e98) - 1i);
let _e2291 = select(_e2289, _e2287, (_e2287 < _e2289));
let _e2296 = global_4.member[bitcast<u32>(select(0i, _e2291, (_e2291 > 0i)))];
let _e2297 = local_3;
let _e2298 = local_2;
let _e2299 = (_e2297 + _e2298);
let _e2301 = select(_e2289, _e2299, (_e2299 < _e2289));
let _e2306 = global_4.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2307 = local_3;
let _e2309 = local_2;
let _e2310 = ((2i * _e2307) + _e2309);
let _e2312 = select(_e2289, _e2310, (_e2310 < _e2289));
let _e2317 = global_4.member[bitcast<u32>(select(0i, _e2312, (_e2312 > 0i)))];
let _e2318 = local_3;
let _e2320 = local_2;
let _e2321 = ((3i * _e2318) + _e2320);
let _e2323 = select(_e2289, _e2321, (_e2321 < _e2289));
let _e2328 = global_4.member[bitcast<u32>(select(0i, _e2323, (_e2323 > 0i)))];
let _e2329 = bitcast<i32>(_e2227);
let _e2330 = f32(_e2329);
let _e2331 = bitcast<i32>(_e2234);
let _e2332 = f32(_e2331);
let _e2339 = global_1.member.member_2.member;
let _e2340 = (((((select(_e1167, _e2220, _e692) + 0.5f) / _e2330) * 2f) - 1f) * _e2339);
let _e2347 = global_1.member.member_2.member_1;
let _e2348 = ((1f - (((select(_e2220, _e1167, _e692) + 0.5f) / _e2332) * 2f)) * _e2347);
let _e2350 = global_1.member.member_3;
let _e2358 = global_1.member.member_4;
let _e2365 = ((_e2350.member * _e2340) + (_e2358.member * _e2348));
let _e2366 = ((_e2350.member_1 * _e2340) + (_e2358.member_1 * _e2348));
let _e2367 = ((_e2350.member_2 * _e2340) + (_e2358.member_2 * _e2348));
let _e2370 = global_1.member.member_2.member_3;
let _e2371 = (_e2370 != 0u);
let _e2373 = global_1.member.member_5;
let _e2380 = select((_e2373.member + _e2365), _e2373.member, _e2371);
let _e2381 = select((_e2373.member_1 + _e2366), _e2373.member_1, _e2371);
let _e2382 = select((_e2373.member_2 + _e2367), _e2373.member_2, _e2371);
let _e2384 = global_1.member.member_6;
let _e2398 = (((_e2380 * _e2380) + (_e2381 * _e2381)) + (_e2382 * _e2382));
let _e2401 = sqrt(select(0f, _e2398, (_e2398 > 0f)));
let _e2402 = (1f / _e2401);
let _e2403 = (_e2380 * _e2402);
let _e2404 = (_e2381 * _e2402);
let _e2405 = (_e2382 * _e2402);
let _e2406 = (_e179 - select(_e2384.member, (_e2384.member + _e2365), _e2371));
let _e2407 = (_e191 - select(_e2384.member_1, (_e2384.member_1 + _e2366), _e2371));
let _e2408 = (_e204 - select(_e2384.member_2, (_e2384.member_2 + _e2367), _e2371));
let _e2413 = (((_e2406 * _e2403) + (_e2407 * _e2404)) + (_e2408 * _e2405));
let _e2418 = (((_e2406 * _e217) + (_e2407 * _e230)) + (_e2408 * _e243));
let _e2423 = (((_e2403 * _e217) + (_e2404 * _e230)) + (_e2405 * _e243));
let _e2426 = ((_e2404 * _e243) - (_e2405 * _e230));
let _e2429 = ((_e2405 * _e217) - (_e2403 * _e243));
let _e2432 = ((_e2403 * _e230) - (_e2404 * _e217));
let _e2437 = (((_e2426 * _e2426) + (_e2429 * _e2429)) + (_e2432 * _e2432));
let _e2440 = (1f / select(1e-9f, _e2437, (_e2437 > 1e-9f)));
let _e2443 = ((_e2413 - (_e2423 * _e2418)) * _e2440);
let _e2446 = (((_e2423 * _e2413) - _e2418) * _e2440);
let _e2452 = (_e2443 - _e2328);
let _e2455 = (_e2446 + select(0f, _e2452, (_e2452 > 0f)));
let _e2458 = global_1.member.member_13.member;
let _e2463 = -((_e2458.member * _e2455));
let _e2465 = select(-87f, _e2463, (_e2463 > -87f));
let _e2467 = select(88f, _e2465, (_e2465 < 88f));
let _e2469 = ((_e2467 * 1.442695f) + 0.5f);
let _e2471 = select(-127f, _e2469, (_e2469 > -127f));
let _e2473 = select(128f, _e2471, (_e2471 < 128f));
let _e2480 = select(0i, select(select(i32(_e2473), i32(-2147483648), (_e2473 < -2147483600f)), 2147483647i, (_e2473 > 2147483500f)), (_e2473 == _e2473));
let _e2484 = (_e2480 - select(0i, 1i, (_e2473 < f32(_e2480))));
let _e2485 = f32(_e2484);
let _e2489 = ((_e2467 - (_e2485 * 0.6933594f)) - (_e2485 * -2.1219444e-4f));
let _e2511 = -((_e2458.member_1 * _e2455));
let _e2513 = select(-87f, _e2511, (_e2511 > -87f));
let _e2515 = select(88f, _e2513, (_e2513 < 88f));
let _e2517 = ((_e2515 * 1.442695f) + 0.5f);
let _e2519 = select(-127f, _e2517, (_e2517 > -127f));
let _e2521 = select(128f, _e2519, (_e2519 < 128f));
let _e2528 = select(0i, select(select(i32(_e2521), i32(-2147483648), (_e2521 < -2147483600f)), 2147483647i, (_e2521 > 2147483500f)), (_e2521 == _e2521));
let _e2532 = (_e2528 - select(0i, 1i, (_e2521 < f32(_e2528))));
let _e2533 = f32(_e2532);
let _e2537 = ((_e2515 - (_e2533 * 0.6933594f)) - (_e2533 * -2.1219444e-4f));
let _e2559 = -((_e2458.member_2 * _e2455));
let _e2561 = select(-87f, _e2559, (_e2559 > -87f));
let _e2563 = select(88f, _e2561, (_e2561 < 88f));
let _e2565 = ((_e2563 * 1.442695f) + 0.5f);
let _e2567 = select(-127f, _e2565, (_e2565 > -127f));
let _e2569 = select(128f, _e2567, (_e2567 < 128f));
let _e2576 = select(0i, select(select(i32(_e2569), i32(-2147483648), (_e2569 < -2147483600f)), 2147483647i, (_e2569 > 2147483500f)), (_e2569 == _e2569));
let _e2580 = (_e2576 - select(0i, 1i, (_e2569 < f32(_e2576))));
let _e2581 = f32(_e2580);
let _e2585 = ((_e2563 - (_e2581 * 0.6933594f)) - (_e2581 * -2.1219444e-4f));
let _e2606 = -(_e2423);
let _e2609 = global_1.member.member_13.member_2;
let _e2610 = (_e2609 * _e2609);
let _e2611 = (1f + _e2610);
let _e2612 = (2f * _e2609);
let _e2614 = (_e2611 - (_e2612 * _e2606));
let _e2616 = select(1e-9f, _e2614, (_e2614 > 1e-9f));
let _e2617 = (1f - _e2610);
let _e2628 = global_1.member.member_13.member_3;
let _e2629 = (_e2628 == 1u);
let _e2631 = (0.25f / 3.1415927f);
let _e2633 = (_e2401 * (select((_e2617 / (_e2616 * sqrt(select(0f, _e2616, (_e2616 > 0f))))), (0.75f * (1f + (_e2606 * _e2606))), _e2629) * _e2631));
let _e2636 = global_1.member.member_13.member_1;
let _e2640 = (_e412 * _e2636.member);
let _e2641 = (_e425 * _e2636.member_1);
let _e2642 = (_e438 * _e2636.member_2);
let _e2649 = select(0f, _e2443, (((_e2446 >= 0f) && (_e2446 < _e451)) && (_e2443 > 0f)));
if (_e2649 > _e2306) {
} else {
let _e2653 = ((_e2649 > 0f) && (_e2649 < _e2296));
if _e2653 {
let _e2655 = ((_e2220 - _e1171) * _e701);
let _e2656 = (_e701 * _e1141);
let _e2657 = (1e-4f * _e2656);
let _e2659 = select(_e1185, _e1178, (_e1178 > _e1185));
let _e2661 = select(_e2657, _e2659, (_e2659 > _e2657));
let _e2663 = select(_e1185, _e1178, (_e1178 < _e1185));
let _e2665 = select(_e2657, _e2663, (_e2663 > _e2657));
let _e2666 = (0.5f * _e2656);
let _e2667 = (_e2655 + _e2666);
let _e2668 = -(_e2667);
let _e2672 = (0.5f * (_e2661 + _e2665));
let _e2673 = (_e2672 - select(_e2668, _e2667, (_e2667 > _e2668)));
let _e2675 = select(0f, _e2673, (_e2673 > 0f));
let _e2677 = select(_e2665, _e2675, (_e2675 < _e2665));
let _e2681 = (_e2673 - _e2665);
let _e2685 = ((((_e2677 * (_e2677 / _e2665)) * 0.5f) + select(0f, _e2681, (_e2681 > 0f))) / _e2661);
let _e2689 = (_e2655 - _e2666);
let _e2690 = -(_e2689);
let _e2693 = (_e2672 - select(_e2690, _e2689, (_e2689 > _e2690)));
let _e2695 = select(0f, _e2693, (_e2693 > 0f));
let _e2697 = select(_e2665, _e2695, (_e2695 < _e2665));
let _e2701 = (_e2693 - _e2665);
let _e2705 = ((((_e2697 * (_e2697 / _e2665)) * 0.5f) + select(0f, _e2701, (_e2701 > 0f))) / _e2661);
let _e2710 = ((select(_e2685, (1f - _e2685), (_e2667 >= 0f)) - select(_e2705, (1f - _e2705), (_e2689 >= 0f))) / _e2656);
phi_4831_ = 0u;
phi_4834_ = 0u;
loop {
let _e2715 = phi_4831_;
let _e2717 = phi_4834_;
local_18 = _e2717;
let _e2718 = (_e2715 < _e983);
if _e2718 {
let _e2719 = (_e2715 & 31u);
let _e2721 = (1u << bitcast<u32>(_e2719));
phi_4832_ = (_e2715 + 1u);
phi_4835_ = (_e2717 + ((((_e2227 + _e2721) - 1u) >> bitcast<u32>(_e2719)) * (((_e2234 + _e2721) - 1u) >> bitcast<u32>(_e2719))));
} else {
phi_4832_ = u32();
phi_4835_ = u32();
}
let _e2734 = phi_4832_;
let _e2736 = phi_4835_;
continue;
continuing {
phi_4831_ = _e2734;
phi_4834_ = _e2736;
break if !(_e2718);
}
}
let _e2739 = local_18;
let _e2751 = (((bitcast<i32>(_e2739) + (_e2224 * bitcast<i32>((((_e2227 + (1u << bitcast<u32>(_e1138))) - 1u) >> bitcast<u32>(_e1138))))) + _e2223) * 6i);
let _e2754 = global_1.member.member_18.member;
let _e2755 = ((((_e2640 * ((1f + (_e2489 * (1f + (_e2489 * (0.5f + (_e2489 * (0.16666667f + (_e2489 * (0.041666668f + (_e2489 * (0.008333334f + (_e2489 * (0.001388889f + (_e2489 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2484 + 127i)) << bitcast<u32>(23i))))) * _e2633) * _e2710) * _e2754);
if (bitcast<f32>((bitcast<u32>(_e2755) & 2147483647u)) < 1073741800f) {
let _e2761 = ((_e2755 * 1f) + 0.5f);
let _e2763 = select(-1073741800f, _e2761, (_e2761 > -1073741800f));
let _e2765 = select(1073741800f, _e2763, (_e2763 < 1073741800f));
let _e2772 = select(0i, select(select(i32(_e2765), i32(-2147483648), (_e2765 < -2147483600f)), 2147483647i, (_e2765 > 2147483500f)), (_e2765 == _e2765));
let _e2776 = (_e2772 - select(0i, 1i, (_e2765 < f32(_e2772))));
if (_e2776 == 0i) {
} else {
let _e2778 = bitcast<u32>(_e2776);
let _e2779 = bitcast<u32>(_e2751);
if (_e2779 < _e100) {
let _e2783 = atomicAdd((&global_5.member[_e2779]), _e2778);
phi_4923_ = _e2783;
} else {
phi_4923_ = 0u;
}
let _e2785 = phi_4923_;
let _e2792 = (bitcast<u32>((_e2776 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2785 + _e2778) < _e2778)));
if (_e2792 == 0u) {
} else {
let _e2794 = (_e2779 + 1u);
if (_e2794 < _e100) {
let _e2798 = atomicAdd((&global_5.member[_e2794]), _e2792);
}
}
}
} else {
let _e2801 = ((_e2755 * (1f / 1048576f)) + 0.5f);
let _e2803 = select(-1073741800f, _e2801, (_e2801 > -1073741800f));
let _e2805 = select(1073741800f, _e2803, (_e2803 < 1073741800f));
let _e2812 = select(0i, select(select(i32(_e2805), i32(-2147483648), (_e2805 < -2147483600f)), 2147483647i, (_e2805 > 2147483500f)), (_e2805 == _e2805));
let _e2816 = (_e2812 - select(0i, 1i, (_e2805 < f32(_e2812))));
let _e2819 = (bitcast<u32>(_e2816) << bitcast<u32>(20i));
let _e2820 = bitcast<u32>(_e2751);
if (_e2820 < _e100) {
let _e2824 = atomicAdd((&global_5.member[_e2820]), _e2819);
phi_4977_ = _e2824;
} else {
phi_4977_ = 0u;
}
let _e2826 = phi_4977_;
let _e2830 = (_e2820 + 1u);
if (_e2830 < _e100) {
let _e2838 = atomicAdd((&global_5.member[_e2830]), (bitcast<u32>((_e2816 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2826 + _e2819) < _e2819))));
}
}
let _e2839 = (_e2751 + 2i);
let _e2840 = ((((_e2641 * ((1f + (_e2537 * (1f + (_e2537 * (0.5f + (_e2537 * (0.16666667f + (_e2537 * (0.041666668f + (_e2537 * (0.008333334f + (_e2537 * (0.001388889f + (_e2537 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2532 + 127i)) << bitcast<u32>(23i))))) * _e2633) * _e2710) * _e2754);
if (bitcast<f32>((bitcast<u32>(_e2840) & 2147483647u)) < 1073741800f) {
let _e2846 = ((_e2840 * 1f) + 0.5f);
let _e2848 = select(-1073741800f, _e2846, (_e2846 > -1073741800f));
let _e2850 = select(1073741800f, _e2848, (_e2848 < 1073741800f));
let _e2857 = select(0i, select(select(i32(_e2850), i32(-2147483648), (_e2850 < -2147483600f)), 2147483647i, (_e2850 > 2147483500f)), (_e2850 == _e2850));
let _e2861 = (_e2857 - select(0i, 1i, (_e2850 < f32(_e2857))));
if (_e2861 == 0i) {
} else {
let _e2863 = bitcast<u32>(_e2861);
let _e2864 = bitcast<u32>(_e2839);
if (_e2864 < _e100) {
let _e2868 = atomicAdd((&global_5.member[_e2864]), _e2863);
phi_5041_ = _e2868;
} else {
phi_5041_ = 0u;
}
let _e2870 = phi_5041_;
let _e2877 = (bitcast<u32>((_e2861 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2870 + _e2863) < _e2863)));
if (_e2877 == 0u) {
} else {
let _e2879 = (_e2864 + 1u);
if (_e2879 < _e100) {
let _e2883 = atomicAdd((&global_5.member[_e2879]), _e2877);
}
}
}
} else {
let _e2886 = ((_e2840 * (1f / 1048576f)) + 0.5f);
let _e2888 = select(-1073741800f, _e2886, (_e2886 > -1073741800f));
let _e2890 = select(1073741800f, _e2888, (_e2888 < 1073741800f));
let _e2897 = select(0i, select(select(i32(_e2890), i32(-2147483648), (_e2890 < -2147483600f)), 2147483647i, (_e2890 > 2147483500f)), (_e2890 == _e2890));
let _e2901 = (_e2897 - select(0i, 1i, (_e2890 < f32(_e2897))));
let _e2904 = (bitcast<u32>(_e2901) << bitcast<u32>(20i));
let _e2905 = bitcast<u32>(_e2839);
if (_e2905 < _e100) {
let _e2909 = atomicAdd((&global_5.member[_e2905]), _e2904);
phi_5095_ = _e2909;
} else {
phi_5095_ = 0u;
}
let _e2911 = phi_5095_;
let _e2915 = (_e2905 + 1u);
if (_e2915 < _e100) {
let _e2923 = atomicAdd((&global_5.member[_e2915]), (bitcast<u32>((_e2901 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2911 + _e2904) < _e2904))));
}
}
let _e2924 = (_e2751 + 4i);
let _e2925 = ((((_e2642 * ((1f + (_e2585 * (1f + (_e2585 * (0.5f + (_e2585 * (0.16666667f + (_e2585 * (0.041666668f + (_e2585 * (0.008333334f + (_e2585 * (0.001388889f + (_e2585 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2580 + 127i)) << bitcast<u32>(23i))))) * _e2633) * _e2710) * _e2754);
if (bitcast<f32>((bitcast<u32>(_e2925) & 2147483647u)) < 1073741800f) {
let _e2931 = ((_e2925 * 1f) + 0.5f);
let _e2933 = select(-1073741800f, _e2931, (_e2931 > -1073741800f));
let _e2935 = select(1073741800f, _e2933, (_e2933 < 1073741800f));
let _e2942 = select(0i, select(select(i32(_e2935), i32(-2147483648), (_e2935 < -2147483600f)), 2147483647i, (_e2935 > 2147483500f)), (_e2935 == _e2935));
let _e2946 = (_e2942 - select(0i, 1i, (_e2935 < f32(_e2942))));
if (_e2946 == 0i) {
} else {
let _e2948 = bitcast<u32>(_e2946);
let _e2949 = bitcast<u32>(_e2924);
if (_e2949 < _e100) {
let _e2953 = atomicAdd((&global_5.member[_e2949]), _e2948);
phi_5159_ = _e2953;
} else {
phi_5159_ = 0u;
}
let _e2955 = phi_5159_;
let _e2962 = (bitcast<u32>((_e2946 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2955 + _e2948) < _e2948)));
if (_e2962 == 0u) {
} else {
let _e2964 = (_e2949 + 1u);
if (_e2964 < _e100) {
let _e2968 = atomicAdd((&global_5.member[_e2964]), _e2962);
}
}
}
} else {
let _e2971 = ((_e2925 * (1f / 1048576f)) + 0.5f);
let _e2973 = select(-1073741800f, _e2971, (_e2971 > -1073741800f));
let _e2975 = select(1073741800f, _e2973, (_e2973 < 1073741800f));
let _e2982 = select(0i, select(select(i32(_e2975), i32(-2147483648), (_e2975 < -2147483600f)), 2147483647i, (_e2975 > 2147483500f)), (_e2975 == _e2975));
let _e2986 = (_e2982 - select(0i, 1i, (_e2975 < f32(_e2982))));
let _e2989 = (bitcast<u32>(_e2986) << bitcast<u32>(20i));
let _e2990 = bitcast<u32>(_e2924);
if (_e2990 < _e100) {
let _e2994 = atomicAdd((&global_5.member[_e2990]), _e2989);
phi_5213_ = _e2994;
} else {
phi_5213_ = 0u;
}
let _e2996 = phi_5213_;
let _e3000 = (_e2990 + 1u);
if (_e3000 < _e100) {
let _e3008 = atomicAdd((&global_5.member[_e3000]), (bitcast<u32>((_e2986 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2996 + _e2989) < _e2989))));
}
}
}
let _e3009 = (_e1162 * _e1140);
let _e3012 = ((_e1162 + 1i) * _e1140);
let _e3015 = (_e1060 == _e983);
let _e3018 = (_e1137 == _e983);
if ((_e2653 && ((!((_e3009 == _e891)) || _e3015) && (!((_e3012 == _e892)) || _e3018))) && ((_e2649 * (1f + (0.02f * _e1141))) < _e2317)) {
} else {
phi_5274_ = _e3009;
loop {
let _e3030 = phi_5274_;
let _e3033 = ((_e3030 < _e3012) && (_e3030 < select(_e2329, _e2331, _e692)));
if _e3033 {
let _e3034 = f32(_e3030);
let _e3038 = (-(((_e693 * _e3034) + _e573)) / _e694);
let _e3045 = bitcast<f32>((bitcast<u32>(((_e695 * _e3034) + ((_e696 * _e3038) + _e629))) & 2147483647u));
let _e3052 = bitcast<f32>((bitcast<u32>(((_e697 * _e3034) + ((_e698 * _e3038) + _e685))) & 2147483647u));
phi_5317_ = (_e1251 * _e1140);
loop {
let _e3055 = phi_5317_;
let _e3060 = ((_e3055 < ((_e1251 + 1i) * _e1140)) && (_e3055 < select(_e2331, _e2329, _e692)));
if _e3060 {
phi_5331_ = 0u;
phi_5334_ = 1f;
loop {
let _e3062 = phi_5331_;
let _e3064 = phi_5334_;
local_20 = _e3064;
local_21 = _e3064;
let _e3065 = (_e3062 < 3u);
if _e3065 {
if (_e3062 == 0u) {
phi_5372_ = _e983;
} else {
if (_e3062 == 1u) {
phi_5371_ = select(_e1060, 0u, _e3015);
} else {
phi_5371_ = select(_e1137, 0u, (_e3018 || (_e1137 == _e1060)));
}
let _e3073 = phi_5371_;
phi_5372_ = _e3073;
}
let _e3075 = phi_5372_;
if (_e3075 > 0u) {
let _e3077 = (_e3075 & 31u);
let _e3079 = (1u << bitcast<u32>(_e3077));
let _e3083 = (((_e2227 + _e3079) - 1u) >> bitcast<u32>(_e3077));
let _e3087 = (((_e2234 + _e3079) - 1u) >> bitcast<u32>(_e3077));
if _e692 {
phi_5403_ = bitcast<i32>(_e3083);
phi_5404_ = bitcast<i32>(_e3087);
} else {
phi_5403_ = bitcast<i32>(_e3087);
phi_5404_ = bitcast<i32>(_e3083);
}
let _e3093 = phi_5403_;
let _e3095 = phi_5404_;
let _e3098 = f32((1i << bitcast<u32>(_e3077)));
let _e3099 = (1f / _e3098);
let _e3102 = (((_e3034 + 0.5f) * _e3099) - 0.5f);
let _e3106 = (((f32(_e3055) + 0.5f) * _e3099) - 0.5f);
let _e3108 = select(-1f, _e3102, (_e3102 > -1f));
let _e3110 = select(1e6f, _e3108, (_e3108 < 1e6f));
let _e3117 = select(0i, select(select(i32(_e3110), i32(-2147483648), (_e3110 < -2147483600f)), 2147483647i, (_e3110 > 2147483500f)), (_e3110 == _e3110));
let _e3121 = (_e3117 - select(0i, 1i, (_e3110 < f32(_e3117))));
let _e3123 = select(-1f, _e3106, (_e3106 > -1f));
let _e3125 = select(1e6f, _e3123, (_e3123 < 1e6f));
let _e3132 = select(0i, select(select(i32(_e3125), i32(-2147483648), (_e3125 < -2147483600f)), 2147483647i, (_e3125 > 2147483500f)), (_e3125 == _e3125));
let _e3136 = (_e3132 - select(0i, 1i, (_e3125 < f32(_e3132))));
let _e3138 = (_e3102 - f32(_e3121));
let _e3140 = (_e3106 - f32(_e3136));
phi_5468_ = 0i;
phi_5471_ = _e3064;
loop {
let _e3142 = phi_5468_;
let _e3144 = phi_5471_;
local_30 = _e3144;
let _e3145 = (_e3142 < 4i);
if _e3145 {
let _e3146 = (_e3142 & 1i);
let _e3147 = (_e3121 + _e3146);
let _e3149 = (_e3142 >> bitcast<u32>(1i));
let _e3150 = (_e3136 + _e3149);
if (_e3147 < _e3095) {
phi_5503_ = _e3147;
} else {
phi_5503_ = (_e3095 - 1i);
}
let _e3161 = phi_5503_;
let _e3163 = select(0i, _e3161, (_e3161 > 0i));
if (_e3150 < _e3093) {
phi_5514_ = _e3150;
} else {
phi_5514_ = (_e3093 - 1i);
}
let _e3167 = phi_5514_;
let _e3169 = select(0i, _e3167, (_e3167 > 0i));
let _e3173 = (((f32(_e3163) + 0.5f) * _e3098) - 0.5f);
let _e3177 = (((f32(_e3169) + 0.5f) * _e3098) - 0.5f);
phi_5599_ = 1u;
phi_5602_ = 0u;
loop {
let _e3183 = phi_5599_;
let _e3185 = phi_5602_;
local_19 = _e3185;
let _e3186 = (_e3183 < _e3075);
if _e3186 {
let _e3187 = (_e3183 & 31u);
phi_5600_ = (_e3183 + 1u);
phi_5603_ = (_e3185 + (((_e2234 + (1u << bitcast<u32>(_e3187))) - 1u) >> bitcast<u32>(_e3187)));
} else {
phi_5600_ = u32();
phi_5603_ = u32();
}
let _e3197 = phi_5600_;
let _e3199 = phi_5603_;
continue;
continuing {
phi_5599_ = _e3197;
phi_5602_ = _e3199;
break if !(_e3186);
}
}
let _e3202 = local_19;
local = (((bitcast<i32>(_e3202) + select(_e3169, _e3163, _e692)) * _e2231) + select(_e3163, _e3169, _e692));
let _e3207 = local;
let _e3209 = select(_e2289, _e3207, (_e3207 < _e2289));
let _e3214 = global_4.member[bitcast<u32>(select(0i, _e3209, (_e3209 > 0i)))];
let _e3219 = (((((select(_e3173, _e3177, _e692) + 0.5f) / _e2330) * 2f) - 1f) * _e2339);
let _e3224 = ((1f - (((select(_e3177, _e3173, _e692) + 0.5f) / _e2332) * 2f)) * _e2347);
let _e3231 = ((_e2350.member * _e3219) + (_e2358.member * _e3224));
let _e3232 = ((_e2350.member_1 * _e3219) + (_e2358.member_1 * _e3224));
let _e3233 = ((_e2350.member_2 * _e3219) + (_e2358.member_2 * _e3224));
let _e3237 = select((_e2373.member + _e3231), _e2373.member, _e2371);
let _e3238 = select((_e2373.member_1 + _e3232), _e2373.member_1, _e2371);
let _e3239 = select((_e2373.member_2 + _e3233), _e2373.member_2, _e2371);
let _e3250 = (((_e3237 * _e3237) + (_e3238 * _e3238)) + (_e3239 * _e3239));
let _e3254 = (1f / sqrt(select(0f, _e3250, (_e3250 > 0f))));
let _e3255 = (_e3237 * _e3254);
let _e3256 = (_e3238 * _e3254);
let _e3257 = (_e3239 * _e3254);
let _e3258 = (_e179 - select(_e2384.member, (_e2384.member + _e3231), _e2371));
let _e3259 = (_e191 - select(_e2384.member_1, (_e2384.member_1 + _e3232), _e2371));
let _e3260 = (_e204 - select(_e2384.member_2, (_e2384.member_2 + _e3233), _e2371));
let _e3265 = (((_e3258 * _e3255) + (_e3259 * _e3256)) + (_e3260 * _e3257));
let _e3270 = (((_e3258 * _e217) + (_e3259 * _e230)) + (_e3260 * _e243));
let _e3275 = (((_e3255 * _e217) + (_e3256 * _e230)) + (_e3257 * _e243));
let _e3278 = ((_e3256 * _e243) - (_e3257 * _e230));
let _e3281 = ((_e3257 * _e217) - (_e3255 * _e243));
let _e3284 = ((_e3255 * _e230) - (_e3256 * _e217));
let _e3289 = (((_e3278 * _e3278) + (_e3281 * _e3281)) + (_e3284 * _e3284));
let _e3292 = (1f / select(1e-9f, _e3289, (_e3289 > 1e-9f)));
let _e3295 = ((_e3265 - (_e3275 * _e3270)) * _e3292);
let _e3298 = (((_e3275 * _e3265) - _e3270) * _e3292);
let _e3304 = select(0f, _e3295, (((_e3298 >= 0f) && (_e3298 < _e451)) && (_e3295 > 0f)));
let _e3306 = (_e3163 << bitcast<u32>(_e3077));
if (_e3306 < _e891) {
phi_6012_ = _e1060;
} else {
phi_6012_ = select(_e983, _e1137, (_e3306 >= _e892));
}
let _e3311 = phi_6012_;
if (((_e3311 == _e3075) && (_e3304 > 0f)) && (_e3304 < _e3214)) {
phi_6022_ = (_e3144 - (select((1f - _e3138), _e3138, (_e3146 == 1i)) * select((1f - _e3140), _e3140, (_e3149 == 1i))));
} else {
phi_6022_ = _e3144;
}
let _e3319 = phi_6022_;
phi_5469_ = (_e3142 + 1i);
phi_5472_ = _e3319;
} else {
phi_5469_ = i32();
phi_5472_ = f32();
}
let _e3322 = phi_5469_;
let _e3324 = phi_5472_;
continue;
continuing {
phi_5468_ = _e3322;
phi_5471_ = _e3324;
break if !(_e3145);
}
}
let _e4090 = local_30;
phi_6024_ = _e4090;
} else {
phi_6024_ = _e3064;
}
let _e3327 = phi_6024_;
phi_5332_ = (_e3062 + 1u);
phi_5335_ = _e3327;
} else {
phi_5332_ = u32();
phi_5335_ = f32();
}
let _e3330 = phi_5332_;
let _e3332 = phi_5335_;
continue;
continuing {
phi_5331_ = _e3330;
phi_5334_ = _e3332;
break if !(_e3065);
}
}
let _e3335 = local_20;
if (bitcast<f32>((bitcast<u32>(_e3335) & 2147483647u)) > 1e-6f) {
let _e3340 = select(_e3030, _e3055, _e692);
let _e3341 = select(_e3055, _e3030, _e692);
let _e3345 = ((_e3341 * _e2329) + _e3340);
let _e3347 = (bitcast<i32>(_e95) - 1i);
let _e3349 = select(_e3347, _e3345, (_e3345 < _e3347));
let _e3354 = global_3.member[bitcast<u32>(select(0i, _e3349, (_e3349 > 0i)))];
let _e3355 = (bitcast<i32>((_e2227 * _e2234)) + _e3345);
let _e3357 = select(_e3347, _e3355, (_e3355 < _e3347));
let _e3362 = global_3.member[bitcast<u32>(select(0i, _e3357, (_e3357 > 0i)))];
let _e3369 = (((((f32(_e3340) + 0.5f) / _e2330) * 2f) - 1f) * _e2339);
let _e3374 = ((1f - (((f32(_e3341) + 0.5f) / _e2332) * 2f)) * _e2347);
let _e3381 = ((_e2350.member * _e3369) + (_e2358.member * _e3374));
let _e3382 = ((_e2350.member_1 * _e3369) + (_e2358.member_1 * _e3374));
let _e3383 = ((_e2350.member_2 * _e3369) + (_e2358.member_2 * _e3374));
let _e3387 = select((_e2373.member + _e3381), _e2373.member, _e2371);
let _e3388 = select((_e2373.member_1 + _e3382), _e2373.member_1, _e2371);
let _e3389 = select((_e2373.member_2 + _e3383), _e2373.member_2, _e2371);
let _e3400 = (((_e3387 * _e3387) + (_e3388 * _e3388)) + (_e3389 * _e3389));
let _e3403 = sqrt(select(0f, _e3400, (_e3400 > 0f)));
let _e3404 = (1f / _e3403);
let _e3405 = (_e3387 * _e3404);
let _e3406 = (_e3388 * _e3404);
let _e3407 = (_e3389 * _e3404);
let _e3408 = (_e179 - select(_e2384.member, (_e2384.member + _e3381), _e2371));
let _e3409 = (_e191 - select(_e2384.member_1, (_e2384.member_1 + _e3382), _e2371));
let _e3410 = (_e204 - select(_e2384.member_2, (_e2384.member_2 + _e3383), _e2371));
let _e3415 = (((_e3408 * _e3405) + (_e3409 * _e3406)) + (_e3410 * _e3407));
let _e3420 = (((_e3408 * _e217) + (_e3409 * _e230)) + (_e3410 * _e243));
let _e3425 = (((_e3405 * _e217) + (_e3406 * _e230)) + (_e3407 * _e243));
let _e3428 = ((_e3406 * _e243) - (_e3407 * _e230));
let _e3431 = ((_e3407 * _e217) - (_e3405 * _e243));
let _e3434 = ((_e3405 * _e230) - (_e3406 * _e217));
let _e3439 = (((_e3428 * _e3428) + (_e3431 * _e3431)) + (_e3434 * _e3434));
let _e3442 = (1f / select(1e-9f, _e3439, (_e3439 > 1e-9f)));
let _e3445 = ((_e3415 - (_e3425 * _e3420)) * _e3442);
let _e3448 = (((_e3425 * _e3415) - _e3420) * _e3442);
let _e3454 = (_e3445 - _e3362);
let _e3457 = (_e3448 + select(0f, _e3454, (_e3454 > 0f)));
let _e3459 = -((_e2458.member * _e3457));
let _e3461 = select(-87f, _e3459, (_e3459 > -87f));
let _e3463 = select(88f, _e3461, (_e3461 < 88f));
let _e3465 = ((_e3463 * 1.442695f) + 0.5f);
let _e3467 = select(-127f, _e3465, (_e3465 > -127f));
let _e3469 = select(128f, _e3467, (_e3467 < 128f));
let _e3476 = select(0i, select(select(i32(_e3469), i32(-2147483648), (_e3469 < -2147483600f)), 2147483647i, (_e3469 > 2147483500f)), (_e3469 == _e3469));
let _e3480 = (_e3476 - select(0i, 1i, (_e3469 < f32(_e3476))));
let _e3481 = f32(_e3480);
let _e3485 = ((_e3463 - (_e3481 * 0.6933594f)) - (_e3481 * -2.1219444e-4f));
let _e3507 = -((_e2458.member_1 * _e3457));
let _e3509 = select(-87f, _e3507, (_e3507 > -87f));
let _e3511 = select(88f, _e3509, (_e3509 < 88f));
let _e3513 = ((_e3511 * 1.442695f) + 0.5f);
let _e3515 = select(-127f, _e3513, (_e3513 > -127f));
let _e3517 = select(128f, _e3515, (_e3515 < 128f));
let _e3524 = select(0i, select(select(i32(_e3517), i32(-2147483648), (_e3517 < -2147483600f)), 2147483647i, (_e3517 > 2147483500f)), (_e3517 == _e3517));
let _e3528 = (_e3524 - select(0i, 1i, (_e3517 < f32(_e3524))));
let _e3529 = f32(_e3528);
let _e3533 = ((_e3511 - (_e3529 * 0.6933594f)) - (_e3529 * -2.1219444e-4f));
let _e3555 = -((_e2458.member_2 * _e3457));
let _e3557 = select(-87f, _e3555, (_e3555 > -87f));
let _e3559 = select(88f, _e3557, (_e3557 < 88f));
let _e3561 = ((_e3559 * 1.442695f) + 0.5f);
let _e3563 = select(-127f, _e3561, (_e3561 > -127f));
let _e3565 = select(128f, _e3563, (_e3563 < 128f));
let _e3572 = select(0i, select(select(i32(_e3565), i32(-2147483648), (_e3565 < -2147483600f)), 2147483647i, (_e3565 > 2147483500f)), (_e3565 == _e3565));
let _e3576 = (_e3572 - select(0i, 1i, (_e3565 < f32(_e3572))));
let _e3577 = f32(_e3576);
let _e3581 = ((_e3559 - (_e3577 * 0.6933594f)) - (_e3577 * -2.1219444e-4f));
let _e3602 = -(_e3425);
let _e3604 = (_e2611 - (_e2612 * _e3602));
let _e3606 = select(1e-9f, _e3604, (_e3604 > 1e-9f));
let _e3617 = (_e3403 * (select((_e2617 / (_e3606 * sqrt(select(0f, _e3606, (_e3606 > 0f))))), (0.75f * (1f + (_e3602 * _e3602))), _e2629) * _e2631));
let _e3624 = select(0f, _e3445, (((_e3448 >= 0f) && (_e3448 < _e451)) && (_e3445 > 0f)));
if ((_e3624 > 0f) && (_e3624 < _e3354)) {
let _e3630 = ((f32(_e3055) - _e3038) * _e701);
let _e3631 = (_e701 * 1f);
let _e3632 = (1e-4f * _e3631);
let _e3634 = select(_e3052, _e3045, (_e3045 > _e3052));
let _e3636 = select(_e3632, _e3634, (_e3634 > _e3632));
let _e3638 = select(_e3052, _e3045, (_e3045 < _e3052));
let _e3640 = select(_e3632, _e3638, (_e3638 > _e3632));
let _e3641 = (0.5f * _e3631);
let _e3642 = (_e3630 + _e3641);
let _e3643 = -(_e3642);
let _e3647 = (0.5f * (_e3636 + _e3640));
let _e3648 = (_e3647 - select(_e3643, _e3642, (_e3642 > _e3643)));
let _e3650 = select(0f, _e3648, (_e3648 > 0f));
let _e3652 = select(_e3640, _e3650, (_e3650 < _e3640));
let _e3656 = (_e3648 - _e3640);
let _e3660 = ((((_e3652 * (_e3652 / _e3640)) * 0.5f) + select(0f, _e3656, (_e3656 > 0f))) / _e3636);
let _e3664 = (_e3630 - _e3641);
let _e3665 = -(_e3664);
let _e3668 = (_e3647 - select(_e3665, _e3664, (_e3664 > _e3665)));
let _e3670 = select(0f, _e3668, (_e3668 > 0f));
let _e3672 = select(_e3640, _e3670, (_e3670 < _e3640));
let _e3676 = (_e3668 - _e3640);
let _e3680 = ((((_e3672 * (_e3672 / _e3640)) * 0.5f) + select(0f, _e3676, (_e3676 > 0f))) / _e3636);
let _e3687 = local_21;
let _e3688 = (((select(_e3660, (1f - _e3660), (_e3642 >= 0f)) - select(_e3680, (1f - _e3680), (_e3664 >= 0f))) / _e3631) * _e3687);
let _e3692 = (_e3345 * 6i);
let _e3695 = global_1.member.member_18.member;
let _e3696 = ((((_e2640 * ((1f + (_e3485 * (1f + (_e3485 * (0.5f + (_e3485 * (0.16666667f + (_e3485 * (0.041666668f + (_e3485 * (0.008333334f + (_e3485 * (0.001388889f + (_e3485 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3480 + 127i)) << bitcast<u32>(23i))))) * _e3617) * _e3688) * _e3695);
if (bitcast<f32>((bitcast<u32>(_e3696) & 2147483647u)) < 1073741800f) {
let _e3702 = ((_e3696 * 1f) + 0.5f);
let _e3704 = select(-1073741800f, _e3702, (_e3702 > -1073741800f));
let _e3706 = select(1073741800f, _e3704, (_e3704 < 1073741800f));
let _e3713 = select(0i, select(select(i32(_e3706), i32(-2147483648), (_e3706 < -2147483600f)), 2147483647i, (_e3706 > 2147483500f)), (_e3706 == _e3706));
let _e3717 = (_e3713 - select(0i, 1i, (_e3706 < f32(_e3713))));
if (_e3717 == 0i) {
} else {
let _e3719 = bitcast<u32>(_e3717);
let _e3720 = bitcast<u32>(_e3692);
if (_e3720 < _e100) {
let _e3724 = atomicAdd((&global_5.member[_e3720]), _e3719);
phi_6750_ = _e3724;
} else {
phi_6750_ = 0u;
}
let _e3726 = phi_6750_;
let _e3733 = (bitcast<u32>((_e3717 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3726 + _e3719) < _e3719)));
if (_e3733 == 0u) {
} else {
let _e3735 = (_e3720 + 1u);
if (_e3735 < _e100) {
let _e3739 = atomicAdd((&global_5.member[_e3735]), _e3733);
}
}
}
} else {
let _e3742 = ((_e3696 * (1f / 1048576f)) + 0.5f);
let _e3744 = select(-1073741800f, _e3742, (_e3742 > -1073741800f));
let _e3746 = select(1073741800f, _e3744, (_e3744 < 1073741800f));
let _e3753 = select(0i, select(select(i32(_e3746), i32(-2147483648), (_e3746 < -2147483600f)), 2147483647i, (_e3746 > 2147483500f)), (_e3746 == _e3746));
let _e3757 = (_e3753 - select(0i, 1i, (_e3746 < f32(_e3753))));
let _e3760 = (bitcast<u32>(_e3757) << bitcast<u32>(20i));
let _e3761 = bitcast<u32>(_e3692);
if (_e3761 < _e100) {
let _e3765 = atomicAdd((&global_5.member[_e3761]), _e3760);
phi_6804_ = _e3765;
} else {
phi_6804_ = 0u;
}
let _e3767 = phi_6804_;
let _e3771 = (_e3761 + 1u);
if (_e3771 < _e100) {
let _e3779 = atomicAdd((&global_5.member[_e3771]), (bitcast<u32>((_e3757 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3767 + _e3760) < _e3760))));
}
}
let _e3780 = (_e3692 + 2i);
let _e3781 = ((((_e2641 * ((1f + (_e3533 * (1f + (_e3533 * (0.5f + (_e3533 * (0.16666667f + (_e3533 * (0.041666668f + (_e3533 * (0.008333334f + (_e3533 * (0.001388889f + (_e3533 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3528 + 127i)) << bitcast<u32>(23i))))) * _e3617) * _e3688) * _e3695);
if (bitcast<f32>((bitcast<u32>(_e3781) & 2147483647u)) < 1073741800f) {
let _e3787 = ((_e3781 * 1f) + 0.5f);
let _e3789 = select(-1073741800f, _e3787, (_e3787 > -1073741800f));
let _e3791 = select(1073741800f, _e3789, (_e3789 < 1073741800f));
let _e3798 = select(0i, select(select(i32(_e3791), i32(-2147483648), (_e3791 < -2147483600f)), 2147483647i, (_e3791 > 2147483500f)), (_e3791 == _e3791));
let _e3802 = (_e3798 - select(0i, 1i, (_e3791 < f32(_e3798))));
if (_e3802 == 0i) {
} else {
let _e3804 = bitcast<u32>(_e3802);
let _e3805 = bitcast<u32>(_e3780);
if (_e3805 < _e100) {
let _e3809 = atomicAdd((&global_5.member[_e3805]), _e3804);
phi_6868_ = _e3809;
} else {
phi_6868_ = 0u;
}
let _e3811 = phi_6868_;
let _e3818 = (bitcast<u32>((_e3802 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3811 + _e3804) < _e3804)));
if (_e3818 == 0u) {
} else {
let _e3820 = (_e3805 + 1u);
if (_e3820 < _e100) {
let _e3824 = atomicAdd((&global_5.member[_e3820]), _e3818);
}
}
}
} else {
let _e3827 = ((_e3781 * (1f / 1048576f)) + 0.5f);
let _e3829 = select(-1073741800f, _e3827, (_e3827 > -1073741800f));
let _e3831 = select(1073741800f, _e3829, (_e3829 < 1073741800f));
let _e3838 = select(0i, select(select(i32(_e3831), i32(-2147483648), (_e3831 < -2147483600f)), 2147483647i, (_e3831 > 2147483500f)), (_e3831 == _e3831));
let _e3842 = (_e3838 - select(0i, 1i, (_e3831 < f32(_e3838))));
let _e3845 = (bitcast<u32>(_e3842) << bitcast<u32>(20i));
let _e3846 = bitcast<u32>(_e3780);
if (_e3846 < _e100) {
let _e3850 = atomicAdd((&global_5.member[_e3846]), _e3845);
phi_6922_ = _e3850;
} else {
phi_6922_ = 0u;
}
let _e3852 = phi_6922_;
let _e3856 = (_e3846 + 1u);
if (_e3856 < _e100) {
let _e3864 = atomicAdd((&global_5.member[_e3856]), (bitcast<u32>((_e3842 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3852 + _e3845) < _e3845))));
}
}
let _e3865 = (_e3692 + 4i);
let _e3866 = ((((_e2642 * ((1f + (_e3581 * (1f + (_e3581 * (0.5f + (_e3581 * (0.16666667f + (_e3581 * (0.041666668f + (_e3581 * (0.008333334f + (_e3581 * (0.001388889f + (_e3581 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3576 + 127i)) << bitcast<u32>(23i))))) * _e3617) * _e3688) * _e3695);
if (bitcast<f32>((bitcast<u32>(_e3866) & 2147483647u)) < 1073741800f) {
let _e3872 = ((_e3866 * 1f) + 0.5f);
let _e3874 = select(-1073741800f, _e3872, (_e3872 > -1073741800f));
let _e3876 = select(1073741800f, _e3874, (_e3874 < 1073741800f));
let _e3883 = select(0i, select(select(i32(_e3876), i32(-2147483648), (_e3876 < -2147483600f)), 2147483647i, (_e3876 > 2147483500f)), (_e3876 == _e3876));
let _e3887 = (_e3883 - select(0i, 1i, (_e3876 < f32(_e3883))));
if (_e3887 == 0i) {
} else {
let _e3889 = bitcast<u32>(_e3887);
let _e3890 = bitcast<u32>(_e3865);
if (_e3890 < _e100) {
let _e3894 = atomicAdd((&global_5.member[_e3890]), _e3889);
phi_6986_ = _e3894;
} else {
phi_6986_ = 0u;
}
let _e3896 = phi_6986_;
let _e3903 = (bitcast<u32>((_e3887 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3896 + _e3889) < _e3889)));
if (_e3903 == 0u) {
} else {
let _e3905 = (_e3890 + 1u);
if (_e3905 < _e100) {
let _e3909 = atomicAdd((&global_5.member[_e3905]), _e3903);
}
}
}
} else {
let _e3912 = ((_e3866 * (1f / 1048576f)) + 0.5f);
let _e3914 = select(-1073741800f, _e3912, (_e3912 > -1073741800f));
let _e3916 = select(1073741800f, _e3914, (_e3914 < 1073741800f));
let _e3923 = select(0i, select(select(i32(_e3916), i32(-2147483648), (_e3916 < -2147483600f)), 2147483647i, (_e3916 > 2147483500f)), (_e3916 == _e3916));
let _e3927 = (_e3923 - select(0i, 1i, (_e3916 < f32(_e3923))));
let _e3930 = (bitcast<u32>(_e3927) << bitcast<u32>(20i));
let _e3931 = bitcast<u32>(_e3865);
if (_e3931 < _e100) {
let _e3935 = atomicAdd((&global_5.member[_e3931]), _e3930);
phi_7040_ = _e3935;
} else {
phi_7040_ = 0u;
}
let _e3937 = phi_7040_;
let _e3941 = (_e3931 + 1u);
if (_e3941 < _e100) {
let _e3949 = atomicAdd((&global_5.member[_e3941]), (bitcast<u32>((_e3927 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3937 + _e3930) < _e3930))));
}
}
}
}
phi_5318_ = (_e3055 + 1i);
} else {
phi_5318_ = i32();
}
let _e3952 = phi_5318_;
continue;
continuing {
phi_5317_ = _e3952;
break if !(_e3060);
}
}
phi_5275_ = (_e3030 + 1i);
} else {
phi_5275_ = i32();
}
let _e3956 = phi_5275_;
continue;
continuing {
phi_5274_ = _e3956;
break if !(_e3033);
}
}
}
}
}
phi_2323_ = (_e1251 + 1i);
} else {
phi_2323_ = i32();
}
let _e3960 = phi_2323_;
continue;
continuing {
phi_2322_ = _e3960;
break if !(_e1252);
}
}
phi_2220_ = (_e1162 + 1i);
} else {
phi_2220_ = i32();
}
let _e3964 = phi_2220_;
continue;
continuing {
phi_2219_ = _e3964;
break if !(_e1163);
}
}
}
}
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
