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
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
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
var phi_1510_: type_22;
var phi_1920_: f32;
var phi_1923_: u32;
var phi_1921_: f32;
var phi_1924_: u32;
var local_12: u32;
var phi_1953_: f32;
var phi_1956_: u32;
var phi_1954_: f32;
var phi_1957_: u32;
var phi_1968_: u32;
var phi_2020_: f32;
var phi_2023_: u32;
var phi_2021_: f32;
var phi_2024_: u32;
var local_13: u32;
var phi_2053_: f32;
var phi_2056_: u32;
var phi_2054_: f32;
var phi_2057_: u32;
var phi_2068_: u32;
var phi_2079_: u32;
var phi_2119_: f32;
var phi_2122_: u32;
var phi_2120_: f32;
var phi_2123_: u32;
var local_14: u32;
var phi_2152_: f32;
var phi_2155_: u32;
var phi_2153_: f32;
var phi_2156_: u32;
var phi_2167_: u32;
var phi_2178_: u32;
var phi_2221_: i32;
var phi_2324_: i32;
var phi_2341_: u32;
var phi_2344_: f32;
var phi_2381_: u32;
var phi_2382_: u32;
var phi_2413_: i32;
var phi_2414_: i32;
var phi_2478_: i32;
var phi_2481_: f32;
var phi_2513_: i32;
var phi_2524_: i32;
var phi_2603_: u32;
var phi_2604_: u32;
var phi_2605_: u32;
var phi_3000_: u32;
var phi_3010_: f32;
var phi_2479_: i32;
var phi_2482_: f32;
var phi_3012_: f32;
var phi_2342_: u32;
var phi_2345_: f32;
var phi_3014_: f32;
var phi_3729_: u32;
var phi_3783_: u32;
var phi_3847_: u32;
var phi_3901_: u32;
var phi_3965_: u32;
var phi_4019_: u32;
var phi_4110_: u32;
var phi_4111_: u32;
var phi_4112_: u32;
var phi_4812_: u32;
var phi_4813_: u32;
var phi_4814_: u32;
var phi_4881_: u32;
var phi_4935_: u32;
var phi_4999_: u32;
var phi_5053_: u32;
var phi_5117_: u32;
var phi_5171_: u32;
var phi_5232_: i32;
var phi_5275_: i32;
var phi_5289_: u32;
var phi_5292_: f32;
var phi_5329_: u32;
var phi_5330_: u32;
var phi_5361_: i32;
var phi_5362_: i32;
var phi_5426_: i32;
var phi_5429_: f32;
var phi_5461_: i32;
var phi_5472_: i32;
var phi_5551_: u32;
var phi_5552_: u32;
var phi_5553_: u32;
var phi_5948_: u32;
var phi_5958_: f32;
var phi_5427_: i32;
var phi_5430_: f32;
var phi_5960_: f32;
var phi_5290_: u32;
var phi_5293_: f32;
var local_15: f32;
var local_16: f32;
var phi_6686_: u32;
var phi_6740_: u32;
var phi_6804_: u32;
var phi_6858_: u32;
var phi_6922_: u32;
var phi_6976_: u32;
var phi_5276_: i32;
var phi_5233_: i32;
var phi_2325_: i32;
var phi_2222_: i32;
var local_17: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var local_21: u32;
var local_22: u32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
let _e89 = global;
let _e96 = arrayLength((&global_3.member));
let _e99 = arrayLength((&global_4.member));
let _e101 = arrayLength((&global_5.member));
let _e104 = global_1.member.member;
if (_e89.x < _e104.member) {
if (_e89.y < _e104.member_1) {
let _e114 = global_1.member.member.member_1;
let _e115 = bitcast<i32>(_e114);
let _e119 = global_1.member.member_12.member_4;
let _e123 = global_1.member.member_12.member_5;
let _e125 = bitcast<i32>((_e119 * _e123));
let _e126 = bitcast<i32>(_e89.y);
local_9 = _e125;
local_10 = _e126;
local_11 = _e115;
let _e127 = local_9;
let _e128 = local_11;
let _e131 = local_10;
let _e132 = ((_e127 + (18i * _e128)) + _e131);
let _e134 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e136 = select(_e134, _e132, (_e132 < _e134));
let _e141 = global_2.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e142 = local_9;
let _e143 = local_11;
let _e146 = local_10;
let _e147 = ((_e142 + (19i * _e143)) + _e146);
let _e149 = select(_e134, _e147, (_e147 < _e134));
let _e154 = global_2.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e156 = local_9;
let _e157 = local_11;
let _e160 = local_10;
let _e161 = ((_e156 + (20i * _e157)) + _e160);
let _e163 = select(_e134, _e161, (_e161 < _e134));
let _e168 = global_2.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
if (((_e141 + _e154) + _e168) > 0f) {
local_6 = _e125;
local_7 = _e126;
local_8 = _e115;
let _e171 = local_6;
let _e172 = local_7;
let _e173 = (_e171 + _e172);
let _e175 = select(_e134, _e173, (_e173 < _e134));
let _e180 = global_2.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e181 = local_6;
let _e182 = local_8;
let _e184 = local_7;
let _e185 = ((_e181 + _e182) + _e184);
let _e187 = select(_e134, _e185, (_e185 < _e134));
let _e192 = global_2.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e193 = local_6;
let _e194 = local_8;
let _e197 = local_7;
let _e198 = ((_e193 + (2i * _e194)) + _e197);
let _e200 = select(_e134, _e198, (_e198 < _e134));
let _e205 = global_2.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e206 = local_6;
let _e207 = local_8;
let _e210 = local_7;
let _e211 = ((_e206 + (3i * _e207)) + _e210);
let _e213 = select(_e134, _e211, (_e211 < _e134));
let _e218 = global_2.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e219 = local_6;
let _e220 = local_8;
let _e223 = local_7;
let _e224 = ((_e219 + (4i * _e220)) + _e223);
let _e226 = select(_e134, _e224, (_e224 < _e134));
let _e231 = global_2.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e232 = local_6;
let _e233 = local_8;
let _e236 = local_7;
let _e237 = ((_e232 + (5i * _e233)) + _e236);
let _e239 = select(_e134, _e237, (_e237 < _e134));
let _e244 = global_2.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e245 = local_6;
let _e246 = local_8;
let _e249 = local_7;
let _e250 = ((_e245 + (6i * _e246)) + _e249);
let _e252 = select(_e134, _e250, (_e250 < _e134));
let _e257 = global_2.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e258 = local_6;
let _e259 = local_8;
let _e262 = local_7;
let _e263 = ((_e258 + (7i * _e259)) + _e262);
let _e265 = select(_e134, _e263, (_e263 < _e134));
let _e270 = global_2.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e271 = local_6;
let _e272 = local_8;
let _e275 = local_7;
let _e276 = ((_e271 + (8i * _e272)) + _e275);
let _e278 = select(_e134, _e276, (_e276 < _e134));
let _e283 = global_2.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e284 = local_6;
let _e285 = local_8;
let _e288 = local_7;
let _e289 = ((_e284 + (9i * _e285)) + _e288);
let _e291 = select(_e134, _e289, (_e289 < _e134));
let _e296 = global_2.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e297 = local_6;
let _e298 = local_8;
let _e301 = local_7;
let _e302 = ((_e297 + (10i * _e298)) + _e301);
let _e304 = select(_e134, _e302, (_e302 < _e134));
let _e309 = global_2.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e310 = local_6;
let _e311 = local_8;
let _e314 = local_7;
let _e315 = ((_e310 + (11i * _e311)) + _e314);
let _e317 = select(_e134, _e315, (_e315 < _e134));
let _e322 = global_2.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e323 = local_6;
let _e324 = local_8;
let _e327 = local_7;
let _e328 = ((_e323 + (12i * _e324)) + _e327);
let _e330 = select(_e134, _e328, (_e328 < _e134));
let _e335 = global_2.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e336 = local_6;
let _e337 = local_8;
let _e340 = local_7;
let _e341 = ((_e336 + (13i * _e337)) + _e340);
let _e343 = select(_e134, _e341, (_e341 < _e134));
let _e348 = global_2.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e349 = local_6;
let _e350 = local_8;
let _e353 = local_7;
let _e354 = ((_e349 + (14i * _e350)) + _e353);
let _e356 = select(_e134, _e354, (_e354 < _e134));
let _e361 = global_2.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e362 = local_6;
let _e363 = local_8;
let _e366 = local_7;
let _e367 = ((_e362 + (15i * _e363)) + _e366);
let _e369 = select(_e134, _e367, (_e367 < _e134));
let _e374 = global_2.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e375 = local_6;
let _e376 = local_8;
let _e379 = local_7;
let _e380 = ((_e375 + (16i * _e376)) + _e379);
let _e382 = select(_e134, _e380, (_e380 < _e134));
let _e387 = global_2.member[bitcast<u32>(select(0i, _e382, (_e382 > 0i)))];
let _e388 = local_6;
let _e389 = local_8;
let _e392 = local_7;
let _e393 = ((_e388 + (17i * _e389)) + _e392);
let _e395 = select(_e134, _e393, (_e393 < _e134));
let _e400 = global_2.member[bitcast<u32>(select(0i, _e395, (_e395 > 0i)))];
let _e401 = local_6;
let _e402 = local_8;
let _e405 = local_7;
let _e406 = ((_e401 + (18i * _e402)) + _e405);
let _e408 = select(_e134, _e406, (_e406 < _e134));
let _e413 = global_2.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
let _e414 = local_6;
let _e415 = local_8;
let _e418 = local_7;
let _e419 = ((_e414 + (19i * _e415)) + _e418);
let _e421 = select(_e134, _e419, (_e419 < _e134));
let _e426 = global_2.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e427 = local_6;
let _e428 = local_8;
let _e431 = local_7;
let _e432 = ((_e427 + (20i * _e428)) + _e431);
let _e434 = select(_e134, _e432, (_e432 < _e134));
let _e439 = global_2.member[bitcast<u32>(select(0i, _e434, (_e434 > 0i)))];
let _e440 = local_6;
let _e441 = local_8;
let _e444 = local_7;
let _e445 = ((_e440 + (23i * _e441)) + _e444);
let _e447 = select(_e134, _e445, (_e445 < _e134));
let _e452 = global_2.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e455 = global_1.member.member_6;
let _e459 = (_e180 - _e455.member);
let _e460 = (_e192 - _e455.member_1);
let _e461 = (_e205 - _e455.member_2);
let _e464 = ((_e460 * _e244) - (_e461 * _e231));
let _e467 = ((_e461 * _e218) - (_e459 * _e244));
let _e470 = ((_e459 * _e231) - (_e460 * _e218));
let _e473 = global_1.member.member_3;
let _e479 = global_1.member.member_4;
let _e485 = global_1.member.member_5;
let _e492 = global_1.member.member_2.member_3;
let _e493 = (_e492 != 0u);
let _e496 = ((_e485.member_1 * _e473.member_2) - (_e485.member_2 * _e473.member_1));
let _e499 = ((_e485.member_2 * _e473.member) - (_e485.member * _e473.member_2));
let _e502 = ((_e485.member * _e473.member_1) - (_e485.member_1 * _e473.member));
let _e514 = select((((_e473.member * _e464) + (_e473.member_1 * _e467)) + (_e473.member_2 * _e470)), -((((_e496 * _e218) + (_e499 * _e231)) + (_e502 * _e244))), _e493);
let _e517 = ((_e485.member_1 * _e479.member_2) - (_e485.member_2 * _e479.member_1));
let _e520 = ((_e485.member_2 * _e479.member) - (_e485.member * _e479.member_2));
let _e523 = ((_e485.member * _e479.member_1) - (_e485.member_1 * _e479.member));
let _e535 = select((((_e479.member * _e464) + (_e479.member_1 * _e467)) + (_e479.member_2 * _e470)), -((((_e517 * _e218) + (_e520 * _e231)) + (_e523 * _e244))), _e493);
let _e544 = global_1.member.member_1.member;
let _e545 = bitcast<i32>(_e544);
let _e546 = f32(_e545);
let _e550 = global_1.member.member_1.member_1;
let _e552 = f32(bitcast<i32>(_e550));
let _e556 = global_1.member.member_2.member;
let _e560 = global_1.member.member_2.member_1;
let _e562 = ((2f * _e556) / _e546);
let _e563 = (_e514 * _e562);
let _e565 = ((-2f * _e560) / _e552);
let _e566 = (_e535 * _e565);
let _e568 = ((_e556 / _e546) - _e556);
let _e572 = (_e560 - (_e560 / _e552));
let _e574 = (((((_e485.member * _e464) + (_e485.member_1 * _e467)) + (_e485.member_2 * _e470)) + (_e514 * _e568)) + (_e535 * _e572));
let _e593 = (((_e270 * _e244) - (_e283 * _e231)) + ((_e460 * _e361) - (_e461 * _e348)));
let _e594 = (((_e283 * _e218) - (_e257 * _e244)) + ((_e461 * _e335) - (_e459 * _e361)));
let _e595 = (((_e257 * _e231) - (_e270 * _e218)) + ((_e459 * _e348) - (_e460 * _e335)));
let _e607 = select((((_e473.member * _e593) + (_e473.member_1 * _e594)) + (_e473.member_2 * _e595)), -((((_e496 * _e335) + (_e499 * _e348)) + (_e502 * _e361))), _e493);
let _e619 = select((((_e479.member * _e593) + (_e479.member_1 * _e594)) + (_e479.member_2 * _e595)), -((((_e517 * _e335) + (_e520 * _e348)) + (_e523 * _e361))), _e493);
let _e625 = (_e607 * _e562);
let _e626 = (_e619 * _e565);
let _e630 = (((((_e485.member * _e593) + (_e485.member_1 * _e594)) + (_e485.member_2 * _e595)) + (_e607 * _e568)) + (_e619 * _e572));
let _e649 = (((_e309 * _e244) - (_e322 * _e231)) + ((_e460 * _e400) - (_e461 * _e387)));
let _e650 = (((_e322 * _e218) - (_e296 * _e244)) + ((_e461 * _e374) - (_e459 * _e400)));
let _e651 = (((_e296 * _e231) - (_e309 * _e218)) + ((_e459 * _e387) - (_e460 * _e374)));
let _e663 = select((((_e473.member * _e649) + (_e473.member_1 * _e650)) + (_e473.member_2 * _e651)), -((((_e496 * _e374) + (_e499 * _e387)) + (_e502 * _e400))), _e493);
let _e675 = select((((_e479.member * _e649) + (_e479.member_1 * _e650)) + (_e479.member_2 * _e651)), -((((_e517 * _e374) + (_e520 * _e387)) + (_e523 * _e400))), _e493);
let _e681 = (_e663 * _e562);
let _e682 = (_e675 * _e565);
let _e686 = (((((_e485.member * _e649) + (_e485.member_1 * _e650)) + (_e485.member_2 * _e651)) + (_e663 * _e568)) + (_e675 * _e572));
let _e693 = (bitcast<f32>((bitcast<u32>(_e563) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e566) & 2147483647u)));
let _e694 = select(_e563, _e566, _e693);
let _e695 = select(_e566, _e563, _e693);
let _e696 = select(_e625, _e626, _e693);
let _e697 = select(_e626, _e625, _e693);
let _e698 = select(_e681, _e682, _e693);
let _e699 = select(_e682, _e681, _e693);
let _e702 = bitcast<f32>((bitcast<u32>(_e695) & 2147483647u));
let _e708 = ((((_e485.member * _e459) + (_e485.member_1 * _e460)) + (_e485.member_2 * _e461)) - 1e-3f);
let _e713 = (((_e485.member * _e218) + (_e485.member_1 * _e231)) + (_e485.member_2 * _e244));
if (_e492 == 0u) {
let _e716 = (_e713 == 0f);
let _e718 = (-(_e708) / select(_e713, 1e-30f, _e716));
phi_1510_ = type_22(select(0f, select(0f, _e718, (_e718 > 0f)), (_e713 > 0f)), select(select(_e452, select(_e452, _e718, (_e718 < _e452)), (_e713 < 0f)), -1f, (_e716 && (_e708 < 0f))));
} else {
phi_1510_ = type_22(0f, _e452);
}
let _e733 = phi_1510_;
if ((_e702 <= 0f) || (_e733.member_1 <= _e733.member)) {
} else {
let _e745 = ((_e180 + (_e218 * _e733.member)) - _e455.member);
let _e746 = ((_e192 + (_e231 * _e733.member)) - _e455.member_1);
let _e747 = ((_e205 + (_e244 * _e733.member)) - _e455.member_2);
let _e752 = (((_e485.member * _e745) + (_e485.member_1 * _e746)) + (_e485.member_2 * _e747));
let _e756 = select((1f / select(1e-3f, _e752, (_e752 > 1e-3f))), 1f, _e493);
let _e765 = (0.5f * _e546);
let _e767 = ((((((((_e473.member * _e745) + (_e473.member_1 * _e746)) + (_e473.member_2 * _e747)) * _e756) / _e556) + 1f) * _e765) - 0.5f);
let _e776 = (0.5f * _e552);
let _e778 = (((1f - (((((_e479.member * _e745) + (_e479.member_1 * _e746)) + (_e479.member_2 * _e747)) * _e756) / _e560)) * _e776) - 0.5f);
let _e779 = -(1e6f);
let _e781 = select(_e779, _e767, (_e767 > _e779));
let _e783 = select(1e6f, _e781, (_e781 < 1e6f));
let _e785 = select(_e779, _e778, (_e778 > _e779));
let _e787 = select(1e6f, _e785, (_e785 < 1e6f));
let _e788 = select(_e783, _e787, _e693);
let _e789 = select(_e787, _e783, _e693);
let _e807 = (bitcast<f32>((bitcast<u32>(_e694) & 2147483647u)) / _e702);
let _e811 = (0.5f * 1f);
let _e813 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e696 * _e788) + ((_e697 * _e789) + _e630))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e698 * _e788) + ((_e699 * _e789) + _e686))) & 2147483647u)))) / _e702) + _e811) * _e807);
let _e816 = (select(1e6f, _e813, (_e813 < 1e6f)) + 1f);
let _e823 = ((_e180 + (_e218 * _e733.member_1)) - _e455.member);
let _e824 = ((_e192 + (_e231 * _e733.member_1)) - _e455.member_1);
let _e825 = ((_e205 + (_e244 * _e733.member_1)) - _e455.member_2);
let _e830 = (((_e485.member * _e823) + (_e485.member_1 * _e824)) + (_e485.member_2 * _e825));
let _e834 = select((1f / select(1e-3f, _e830, (_e830 > 1e-3f))), 1f, _e493);
let _e844 = ((((((((_e473.member * _e823) + (_e473.member_1 * _e824)) + (_e473.member_2 * _e825)) * _e834) / _e556) + 1f) * _e765) - 0.5f);
let _e854 = (((1f - (((((_e479.member * _e823) + (_e479.member_1 * _e824)) + (_e479.member_2 * _e825)) * _e834) / _e560)) * _e776) - 0.5f);
let _e856 = select(_e779, _e844, (_e844 > _e779));
let _e858 = select(1e6f, _e856, (_e856 < 1e6f));
let _e860 = select(_e779, _e854, (_e854 > _e779));
let _e862 = select(1e6f, _e860, (_e860 < 1e6f));
let _e863 = select(_e858, _e862, _e693);
let _e864 = select(_e862, _e858, _e693);
let _e883 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e696 * _e863) + ((_e697 * _e864) + _e630))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e698 * _e863) + ((_e699 * _e864) + _e686))) & 2147483647u)))) / _e702) + _e811) * _e807);
let _e886 = (select(1e6f, _e883, (_e883 < 1e6f)) + 1f);
let _e888 = bitcast<i32>(select(_e544, _e550, _e693));
let _e892 = bitcast<i32>((_e89.x * 16u));
let _e893 = (_e892 + 16i);
let _e894 = (_e863 < _e788);
let _e895 = (_e788 - _e816);
let _e896 = (_e863 - _e886);
let _e898 = select(_e896, _e895, (_e895 < _e896));
let _e899 = (_e788 + _e816);
let _e900 = (_e863 + _e886);
let _e902 = select(_e900, _e899, (_e899 > _e900));
let _e903 = select(_e899, _e900, _e894);
let _e904 = select(_e896, _e895, _e894);
let _e905 = f32(_e892);
let _e907 = (_e892 + 15i);
let _e910 = ((_e902 < _e905) || (_e898 > f32(_e907)));
if _e910 {
} else {
let _e912 = (0.5f * (16f - 1f));
let _e913 = (_e905 + _e912);
let _e917 = (-(((_e694 * _e913) + _e574)) / _e695);
let _e936 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e696 * _e913) + ((_e697 * _e917) + _e630))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e698 * _e913) + ((_e699 * _e917) + _e686))) & 2147483647u)))) / _e702) + _e811));
let _e940 = global_1.member.member_18.member_1;
phi_1920_ = 8f;
phi_1923_ = 0u;
loop {
let _e942 = phi_1920_;
let _e944 = phi_1923_;
local_12 = _e944;
local_17 = _e944;
let _e947 = ((_e944 < _e940) && (_e936 >= _e942));
if _e947 {
phi_1921_ = (_e942 * 2f);
phi_1924_ = (_e944 + 1u);
} else {
phi_1921_ = f32();
phi_1924_ = u32();
}
let _e951 = phi_1921_;
let _e953 = phi_1924_;
continue;
continuing {
phi_1920_ = _e951;
phi_1923_ = _e953;
break if !(_e947);
}
}
let _e956 = local_12;
let _e960 = f32((1i << bitcast<u32>((_e956 & 31u))));
let _e963 = f32(_e893);
if (((_e905 - _e960) > _e903) && ((_e963 + _e960) < _e904)) {
let _e3940 = local_17;
phi_1968_ = _e3940;
} else {
phi_1953_ = 8f;
phi_1956_ = 0u;
loop {
let _e969 = phi_1953_;
let _e971 = phi_1956_;
local_18 = _e971;
let _e974 = ((_e971 < _e940) && ((_e936 * 0.125f) >= _e969));
if _e974 {
phi_1954_ = (_e969 * 2f);
phi_1957_ = (_e971 + 1u);
} else {
phi_1954_ = f32();
phi_1957_ = u32();
}
let _e978 = phi_1954_;
let _e980 = phi_1957_;
continue;
continuing {
phi_1953_ = _e978;
phi_1956_ = _e980;
break if !(_e974);
}
}
let _e3942 = local_18;
phi_1968_ = _e3942;
}
let _e983 = phi_1968_;
let _e984 = select(_e983, 0u, _e910);
if (_e892 > 0i) {
let _e987 = f32((_e892 - 16i));
let _e988 = (_e987 + _e912);
let _e992 = (-(((_e694 * _e988) + _e574)) / _e695);
let _e1011 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e696 * _e988) + ((_e697 * _e992) + _e630))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e698 * _e988) + ((_e699 * _e992) + _e686))) & 2147483647u)))) / _e702) + _e811));
phi_2020_ = 8f;
phi_2023_ = 0u;
loop {
let _e1013 = phi_2020_;
let _e1015 = phi_2023_;
local_13 = _e1015;
local_19 = _e1015;
let _e1018 = ((_e1015 < _e940) && (_e1011 >= _e1013));
if _e1018 {
phi_2021_ = (_e1013 * 2f);
phi_2024_ = (_e1015 + 1u);
} else {
phi_2021_ = f32();
phi_2024_ = u32();
}
let _e1022 = phi_2021_;
let _e1024 = phi_2024_;
continue;
continuing {
phi_2020_ = _e1022;
phi_2023_ = _e1024;
break if !(_e1018);
}
}
let _e1027 = local_13;
let _e1031 = f32((1i << bitcast<u32>((_e1027 & 31u))));
if (((_e987 - _e1031) > _e903) && ((_e905 + _e1031) < _e904)) {
let _e3954 = local_19;
phi_2068_ = _e3954;
} else {
phi_2053_ = 8f;
phi_2056_ = 0u;
loop {
let _e1039 = phi_2053_;
let _e1041 = phi_2056_;
local_20 = _e1041;
let _e1044 = ((_e1041 < _e940) && ((_e1011 * 0.125f) >= _e1039));
if _e1044 {
phi_2054_ = (_e1039 * 2f);
phi_2057_ = (_e1041 + 1u);
} else {
phi_2054_ = f32();
phi_2057_ = u32();
}
let _e1048 = phi_2054_;
let _e1050 = phi_2057_;
continue;
continuing {
phi_2053_ = _e1048;
phi_2056_ = _e1050;
break if !(_e1044);
}
}
let _e3956 = local_20;
phi_2068_ = _e3956;
}
let _e1053 = phi_2068_;
phi_2079_ = select(_e1053, _e984, ((_e902 < _e987) || (_e898 > f32((_e892 - 1i)))));
} else {
phi_2079_ = _e984;
}
let _e1061 = phi_2079_;
let _e1062 = (_e893 < _e888);
if _e1062 {
let _e1064 = (_e963 + _e912);
let _e1068 = (-(((_e694 * _e1064) + _e574)) / _e695);
let _e1087 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e696 * _e1064) + ((_e697 * _e1068) + _e630))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e698 * _e1064) + ((_e699 * _e1068) + _e686))) & 2147483647u)))) / _e702) + _e811));
phi_2119_ = 8f;
phi_2122_ = 0u;
loop {
let _e1089 = phi_2119_;
let _e1091 = phi_2122_;
local_14 = _e1091;
local_21 = _e1091;
let _e1094 = ((_e1091 < _e940) && (_e1087 >= _e1089));
if _e1094 {
phi_2120_ = (_e1089 * 2f);
phi_2123_ = (_e1091 + 1u);
} else {
phi_2120_ = f32();
phi_2123_ = u32();
}
let _e1098 = phi_2120_;
let _e1100 = phi_2123_;
continue;
continuing {
phi_2119_ = _e1098;
phi_2122_ = _e1100;
break if !(_e1094);
}
}
let _e1103 = local_14;
let _e1107 = f32((1i << bitcast<u32>((_e1103 & 31u))));
if (((_e963 - _e1107) > _e903) && ((f32((_e892 + 32i)) + _e1107) < _e904)) {
let _e3969 = local_21;
phi_2167_ = _e3969;
} else {
phi_2152_ = 8f;
phi_2155_ = 0u;
loop {
let _e1116 = phi_2152_;
let _e1118 = phi_2155_;
local_22 = _e1118;
let _e1121 = ((_e1118 < _e940) && ((_e1087 * 0.125f) >= _e1116));
if _e1121 {
phi_2153_ = (_e1116 * 2f);
phi_2156_ = (_e1118 + 1u);
} else {
phi_2153_ = f32();
phi_2156_ = u32();
}
let _e1125 = phi_2153_;
let _e1127 = phi_2156_;
continue;
continuing {
phi_2152_ = _e1125;
phi_2155_ = _e1127;
break if !(_e1121);
}
}
let _e3971 = local_22;
phi_2167_ = _e3971;
}
let _e1130 = phi_2167_;
phi_2178_ = select(_e1130, _e984, ((_e902 < _e963) || (_e898 > f32((_e892 + 31i)))));
} else {
phi_2178_ = _e984;
}
let _e1138 = phi_2178_;
let _e1139 = (_e984 & 31u);
let _e1141 = (1i << bitcast<u32>(_e1139));
let _e1142 = f32(_e1141);
let _e1144 = select(_e905, _e898, (_e898 > _e905));
let _e1161 = f32(((bitcast<i32>(select(_e550, _e544, _e693)) - 1i) >> bitcast<u32>(_e1139)));
phi_2221_ = (select(0i, select(select(i32(_e1144), i32(-2147483648), (_e1144 < -2147483600f)), 2147483647i, (_e1144 > 2147483500f)), (_e1144 == _e1144)) >> bitcast<u32>(_e1139));
loop {
let _e1163 = phi_2221_;
let _e1164 = (_e1163 <= ((select(_e888, _e893, _e1062) - 1i) >> bitcast<u32>(_e1139)));
if _e1164 {
let _e1166 = (f32(_e1163) + 0.5f);
let _e1168 = ((_e1166 * _e1142) - 0.5f);
let _e1172 = (-(((_e694 * _e1168) + _e574)) / _e695);
let _e1179 = bitcast<f32>((bitcast<u32>(((_e696 * _e1168) + ((_e697 * _e1172) + _e630))) & 2147483647u));
let _e1186 = bitcast<f32>((bitcast<u32>(((_e698 * _e1168) + ((_e699 * _e1172) + _e686))) & 2147483647u));
let _e1191 = (((0.5f * (_e1179 + _e1186)) / _e702) + (0.5f * _e1142));
let _e1199 = ((((_e1172 + _e1191) + 0.5f) / _e1142) - 0.5f);
let _e1200 = (((((_e1172 - _e1191) + 0.5f) / _e1142) - 0.5f) + 1f);
let _e1201 = (_e1161 + 1f);
let _e1203 = select(0f, _e1200, (_e1200 > 0f));
let _e1205 = select(_e1201, _e1203, (_e1203 < _e1201));
let _e1212 = select(0i, select(select(i32(_e1205), i32(-2147483648), (_e1205 < -2147483600f)), 2147483647i, (_e1205 > 2147483500f)), (_e1205 == _e1205));
let _e1218 = select(-1f, _e1199, (_e1199 > -1f));
let _e1220 = select(_e1161, _e1218, (_e1218 < _e1161));
let _e1227 = select(0i, select(select(i32(_e1220), i32(-2147483648), (_e1220 < -2147483600f)), 2147483647i, (_e1220 > 2147483500f)), (_e1220 == _e1220));
let _e1232 = (_e984 == 0u);
phi_2324_ = (_e1212 - select(0i, 1i, (_e1205 < f32(_e1212))));
loop {
let _e1252 = phi_2324_;
let _e1253 = (_e1252 <= (_e1227 - select(0i, 1i, (_e1220 < f32(_e1227)))));
if _e1253 {
if _e1232 {
if (_e1232 && (((_e1061 > 0u) && ((2i * (_e1163 - _e892)) < (1i << bitcast<u32>((_e1061 & 31u))))) || ((_e1138 > 0u) && ((2i * (_e907 - _e1163)) < (1i << bitcast<u32>((_e1138 & 31u))))))) {
phi_2341_ = 0u;
phi_2344_ = 1f;
loop {
let _e1255 = phi_2341_;
let _e1257 = phi_2344_;
local_24 = _e1257;
let _e1258 = (_e1255 < 3u);
if _e1258 {
if (_e1255 == 0u) {
phi_2382_ = _e984;
} else {
if (_e1255 == 1u) {
phi_2381_ = select(_e1061, 0u, (_e1061 == _e984));
} else {
phi_2381_ = select(_e1138, 0u, ((_e1138 == _e984) || (_e1138 == _e1061)));
}
let _e1268 = phi_2381_;
phi_2382_ = _e1268;
}
let _e1270 = phi_2382_;
if (_e1270 > 0u) {
let _e1274 = global_1.member.member_1.member;
let _e1277 = global_1.member.member_1.member_1;
let _e1278 = (_e1270 & 31u);
let _e1280 = (1u << bitcast<u32>(_e1278));
let _e1284 = (((_e1274 + _e1280) - 1u) >> bitcast<u32>(_e1278));
let _e1288 = (((_e1277 + _e1280) - 1u) >> bitcast<u32>(_e1278));
if _e693 {
phi_2413_ = bitcast<i32>(_e1284);
phi_2414_ = bitcast<i32>(_e1288);
} else {
phi_2413_ = bitcast<i32>(_e1288);
phi_2414_ = bitcast<i32>(_e1284);
}
let _e1294 = phi_2413_;
let _e1296 = phi_2414_;
let _e1299 = f32((1i << bitcast<u32>(_e1278)));
let _e1300 = (1f / _e1299);
let _e1302 = ((_e1166 * _e1300) - 0.5f);
let _e1306 = (((f32(_e1252) + 0.5f) * _e1300) - 0.5f);
let _e1308 = select(-1f, _e1302, (_e1302 > -1f));
let _e1310 = select(1e6f, _e1308, (_e1308 < 1e6f));
let _e1317 = select(0i, select(select(i32(_e1310), i32(-2147483648), (_e1310 < -2147483600f)), 2147483647i, (_e1310 > 2147483500f)), (_e1310 == _e1310));
let _e1321 = (_e1317 - select(0i, 1i, (_e1310 < f32(_e1317))));
let _e1323 = select(-1f, _e1306, (_e1306 > -1f));
let _e1325 = select(1e6f, _e1323, (_e1323 < 1e6f));
let _e1332 = select(0i, select(select(i32(_e1325), i32(-2147483648), (_e1325 < -2147483600f)), 2147483647i, (_e1325 > 2147483500f)), (_e1325 == _e1325));
let _e1336 = (_e1332 - select(0i, 1i, (_e1325 < f32(_e1332))));
let _e1338 = (_e1302 - f32(_e1321));
let _e1340 = (_e1306 - f32(_e1336));
phi_2478_ = 0i;
phi_2481_ = _e1257;
loop {
let _e1342 = phi_2478_;
let _e1344 = phi_2481_;
local_23 = _e1344;
let _e1345 = (_e1342 < 4i);
if _e1345 {
let _e1346 = (_e1342 & 1i);
let _e1347 = (_e1321 + _e1346);
let _e1349 = (_e1342 >> bitcast<u32>(1i));
let _e1350 = (_e1336 + _e1349);
if (_e1347 < _e1296) {
phi_2513_ = _e1347;
} else {
phi_2513_ = (_e1296 - 1i);
}
let _e1361 = phi_2513_;
let _e1363 = select(0i, _e1361, (_e1361 > 0i));
if (_e1350 < _e1294) {
phi_2524_ = _e1350;
} else {
phi_2524_ = (_e1294 - 1i);
}
let _e1367 = phi_2524_;
let _e1369 = select(0i, _e1367, (_e1367 > 0i));
let _e1373 = (((f32(_e1363) + 0.5f) * _e1299) - 0.5f);
let _e1377 = (((f32(_e1369) + 0.5f) * _e1299) - 0.5f);
let _e1388 = global_1.member.member_18.member_6;
let _e1391 = global_1.member.member_18.member_7;
let _e1394 = global_1.member.member_18.member_8;
if (_e1270 == 0u) {
phi_2605_ = 0u;
} else {
if (_e1270 == 1u) {
phi_2604_ = 0u;
} else {
if (_e1270 == 2u) {
phi_2603_ = _e1388;
} else {
phi_2603_ = select(_e1394, _e1391, (_e1270 == 3u));
}
let _e1401 = phi_2603_;
phi_2604_ = _e1401;
}
let _e1403 = phi_2604_;
phi_2605_ = _e1403;
}
let _e1405 = phi_2605_;
local_4 = (((bitcast<i32>(_e1405) + select(_e1369, _e1363, _e693)) * bitcast<i32>(((_e1274 + 1u) >> bitcast<u32>(1u)))) + select(_e1363, _e1369, _e693));
let _e1410 = local_4;
let _e1412 = (bitcast<i32>(_e99) - 1i);
let _e1414 = select(_e1412, _e1410, (_e1410 < _e1412));
let _e1419 = global_4.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1430 = global_1.member.member_2.member;
let _e1431 = (((((select(_e1373, _e1377, _e693) + 0.5f) / f32(bitcast<i32>(_e1274))) * 2f) - 1f) * _e1430);
let _e1438 = global_1.member.member_2.member_1;
let _e1439 = ((1f - (((select(_e1377, _e1373, _e693) + 0.5f) / f32(bitcast<i32>(_e1277))) * 2f)) * _e1438);
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
let _e1497 = (_e180 - select(_e1475.member, (_e1475.member + _e1456), _e1462));
let _e1498 = (_e192 - select(_e1475.member_1, (_e1475.member_1 + _e1457), _e1462));
let _e1499 = (_e205 - select(_e1475.member_2, (_e1475.member_2 + _e1458), _e1462));
let _e1504 = (((_e1497 * _e1494) + (_e1498 * _e1495)) + (_e1499 * _e1496));
let _e1509 = (((_e1497 * _e218) + (_e1498 * _e231)) + (_e1499 * _e244));
let _e1514 = (((_e1494 * _e218) + (_e1495 * _e231)) + (_e1496 * _e244));
let _e1517 = ((_e1495 * _e244) - (_e1496 * _e231));
let _e1520 = ((_e1496 * _e218) - (_e1494 * _e244));
let _e1523 = ((_e1494 * _e231) - (_e1495 * _e218));
let _e1528 = (((_e1517 * _e1517) + (_e1520 * _e1520)) + (_e1523 * _e1523));
let _e1531 = (1f / select(1e-9f, _e1528, (_e1528 > 1e-9f)));
let _e1534 = ((_e1504 - (_e1514 * _e1509)) * _e1531);
let _e1537 = (((_e1514 * _e1504) - _e1509) * _e1531);
let _e1543 = select(0f, _e1534, (((_e1537 >= 0f) && (_e1537 < _e452)) && (_e1534 > 0f)));
let _e1545 = (_e1363 << bitcast<u32>(_e1278));
if (_e1545 < _e892) {
phi_3000_ = _e1061;
} else {
phi_3000_ = select(_e984, _e1138, (_e1545 >= _e893));
}
let _e1550 = phi_3000_;
if (((_e1550 == _e1270) && (_e1543 > 0f)) && (_e1543 < _e1419)) {
phi_3010_ = (_e1344 - (select((1f - _e1338), _e1338, (_e1346 == 1i)) * select((1f - _e1340), _e1340, (_e1349 == 1i))));
} else {
phi_3010_ = _e1344;
}
let _e1558 = phi_3010_;
phi_2479_ = (_e1342 + 1i);
phi_2482_ = _e1558;
} else {
phi_2479_ = i32();
phi_2482_ = f32();
}
let _e1561 = phi_2479_;
let _e1563 = phi_2482_;
continue;
continuing {
phi_2478_ = _e1561;
phi_2481_ = _e1563;
break if !(_e1345);
}
}
let _e3994 = local_23;
phi_3012_ = _e3994;
} else {
phi_3012_ = _e1257;
}
let _e1566 = phi_3012_;
phi_2342_ = (_e1255 + 1u);
phi_2345_ = _e1566;
} else {
phi_2342_ = u32();
phi_2345_ = f32();
}
let _e1569 = phi_2342_;
let _e1571 = phi_2345_;
continue;
continuing {
phi_2341_ = _e1569;
phi_2344_ = _e1571;
break if !(_e1258);
}
}
let _e3999 = local_24;
phi_3014_ = _e3999;
} else {
phi_3014_ = 1f;
}
let _e1574 = phi_3014_;
let _e1575 = select(_e1163, _e1252, _e693);
let _e1576 = select(_e1252, _e1163, _e693);
let _e1580 = ((_e1576 * _e545) + _e1575);
let _e1582 = (bitcast<i32>(_e96) - 1i);
let _e1584 = select(_e1582, _e1580, (_e1580 < _e1582));
let _e1590 = global_3.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1591 = (bitcast<i32>((_e544 * _e550)) + _e1580);
let _e1593 = select(_e1582, _e1591, (_e1591 < _e1582));
let _e1599 = global_3.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1606 = (((((f32(_e1575) + 0.5f) / _e546) * 2f) - 1f) * _e556);
let _e1611 = ((1f - (((f32(_e1576) + 0.5f) / _e552) * 2f)) * _e560);
let _e1618 = ((_e473.member * _e1606) + (_e479.member * _e1611));
let _e1619 = ((_e473.member_1 * _e1606) + (_e479.member_1 * _e1611));
let _e1620 = ((_e473.member_2 * _e1606) + (_e479.member_2 * _e1611));
let _e1624 = select((_e485.member + _e1618), _e485.member, _e493);
let _e1625 = select((_e485.member_1 + _e1619), _e485.member_1, _e493);
let _e1626 = select((_e485.member_2 + _e1620), _e485.member_2, _e493);
let _e1637 = (((_e1624 * _e1624) + (_e1625 * _e1625)) + (_e1626 * _e1626));
let _e1640 = sqrt(select(0f, _e1637, (_e1637 > 0f)));
let _e1641 = (1f / _e1640);
let _e1642 = (_e1624 * _e1641);
let _e1643 = (_e1625 * _e1641);
let _e1644 = (_e1626 * _e1641);
let _e1645 = (_e180 - select(_e455.member, (_e455.member + _e1618), _e493));
let _e1646 = (_e192 - select(_e455.member_1, (_e455.member_1 + _e1619), _e493));
let _e1647 = (_e205 - select(_e455.member_2, (_e455.member_2 + _e1620), _e493));
let _e1652 = (((_e1645 * _e1642) + (_e1646 * _e1643)) + (_e1647 * _e1644));
let _e1657 = (((_e1645 * _e218) + (_e1646 * _e231)) + (_e1647 * _e244));
let _e1662 = (((_e1642 * _e218) + (_e1643 * _e231)) + (_e1644 * _e244));
let _e1665 = ((_e1643 * _e244) - (_e1644 * _e231));
let _e1668 = ((_e1644 * _e218) - (_e1642 * _e244));
let _e1671 = ((_e1642 * _e231) - (_e1643 * _e218));
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
let _e1892 = select(0f, _e1682, (((_e1685 >= 0f) && (_e1685 < _e452)) && (_e1682 > 0f)));
if ((_e1892 > 0f) && (_e1892 < _e1590)) {
let _e1898 = ((f32(_e1252) - _e1172) * _e702);
let _e1899 = (_e702 * 1f);
let _e1900 = (1e-4f * _e1899);
let _e1902 = select(_e1186, _e1179, (_e1179 > _e1186));
let _e1904 = select(_e1900, _e1902, (_e1902 > _e1900));
let _e1906 = select(_e1186, _e1179, (_e1179 < _e1186));
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
let _e1963 = (((((_e413 * _e1879.member) * ((1f + (_e1729 * (1f + (_e1729 * (0.5f + (_e1729 * (0.16666667f + (_e1729 * (0.041666668f + (_e1729 * (0.008333334f + (_e1729 * (0.001388889f + (_e1729 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1724 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
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
if (_e1987 < _e101) {
let _e1991 = atomicAdd((&global_5.member[_e1987]), _e1986);
phi_3729_ = _e1991;
} else {
phi_3729_ = 0u;
}
let _e1993 = phi_3729_;
let _e2000 = (bitcast<u32>((_e1984 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1993 + _e1986) < _e1986)));
if (_e2000 == 0u) {
} else {
let _e2002 = (_e1987 + 1u);
if (_e2002 < _e101) {
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
if (_e2028 < _e101) {
let _e2032 = atomicAdd((&global_5.member[_e2028]), _e2027);
phi_3783_ = _e2032;
} else {
phi_3783_ = 0u;
}
let _e2034 = phi_3783_;
let _e2038 = (_e2028 + 1u);
if (_e2038 < _e101) {
let _e2046 = atomicAdd((&global_5.member[_e2038]), (bitcast<u32>((_e2024 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2034 + _e2027) < _e2027))));
}
}
let _e2047 = (_e1958 + 2i);
let _e2048 = (((((_e426 * _e1879.member_1) * ((1f + (_e1777 * (1f + (_e1777 * (0.5f + (_e1777 * (0.16666667f + (_e1777 * (0.041666668f + (_e1777 * (0.008333334f + (_e1777 * (0.001388889f + (_e1777 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1772 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
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
if (_e2072 < _e101) {
let _e2076 = atomicAdd((&global_5.member[_e2072]), _e2071);
phi_3847_ = _e2076;
} else {
phi_3847_ = 0u;
}
let _e2078 = phi_3847_;
let _e2085 = (bitcast<u32>((_e2069 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2078 + _e2071) < _e2071)));
if (_e2085 == 0u) {
} else {
let _e2087 = (_e2072 + 1u);
if (_e2087 < _e101) {
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
if (_e2113 < _e101) {
let _e2117 = atomicAdd((&global_5.member[_e2113]), _e2112);
phi_3901_ = _e2117;
} else {
phi_3901_ = 0u;
}
let _e2119 = phi_3901_;
let _e2123 = (_e2113 + 1u);
if (_e2123 < _e101) {
let _e2131 = atomicAdd((&global_5.member[_e2123]), (bitcast<u32>((_e2109 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2119 + _e2112) < _e2112))));
}
}
let _e2132 = (_e1958 + 4i);
let _e2133 = (((((_e439 * _e1879.member_2) * ((1f + (_e1825 * (1f + (_e1825 * (0.5f + (_e1825 * (0.16666667f + (_e1825 * (0.041666668f + (_e1825 * (0.008333334f + (_e1825 * (0.001388889f + (_e1825 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1820 + 127i)) << bitcast<u32>(23i))))) * _e1875) * _e1954) * _e1962);
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
if (_e2157 < _e101) {
let _e2161 = atomicAdd((&global_5.member[_e2157]), _e2156);
phi_3965_ = _e2161;
} else {
phi_3965_ = 0u;
}
let _e2163 = phi_3965_;
let _e2170 = (bitcast<u32>((_e2154 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2163 + _e2156) < _e2156)));
if (_e2170 == 0u) {
} else {
let _e2172 = (_e2157 + 1u);
if (_e2172 < _e101) {
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
if (_e2198 < _e101) {
let _e2202 = atomicAdd((&global_5.member[_e2198]), _e2197);
phi_4019_ = _e2202;
} else {
phi_4019_ = 0u;
}
let _e2204 = phi_4019_;
let _e2208 = (_e2198 + 1u);
if (_e2208 < _e101) {
let _e2216 = atomicAdd((&global_5.member[_e2208]), (bitcast<u32>((_e2194 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2204 + _e2197) < _e2197))));
}
}
}
} else {
let _e2220 = (((f32(_e1252) + 0.5f) * _e1142) - 0.5f);
let _e2223 = select(_e1163, _e1252, _e693);
let _e2224 = select(_e1252, _e1163, _e693);
let _e2227 = global_1.member.member_1.member;
let _e2231 = bitcast<i32>(((_e2227 + 1u) >> bitcast<u32>(1u)));
let _e2234 = global_1.member.member_18.member_9;
let _e2239 = global_1.member.member_18.member_6;
let _e2242 = global_1.member.member_18.member_7;
let _e2245 = global_1.member.member_18.member_8;
if _e1232 {
phi_4112_ = 0u;
} else {
if (_e984 == 1u) {
phi_4111_ = 0u;
} else {
if (_e984 == 2u) {
phi_4110_ = _e2239;
} else {
phi_4110_ = select(_e2245, _e2242, (_e984 == 3u));
}
let _e2251 = phi_4110_;
phi_4111_ = _e2251;
}
let _e2253 = phi_4111_;
phi_4112_ = _e2253;
}
let _e2255 = phi_4112_;
local_2 = (((bitcast<i32>(_e2255) + _e2224) * _e2231) + _e2223);
local_3 = (_e2231 * bitcast<i32>(_e2234));
let _e2260 = local_2;
let _e2262 = (bitcast<i32>(_e99) - 1i);
let _e2264 = select(_e2262, _e2260, (_e2260 < _e2262));
let _e2269 = global_4.member[bitcast<u32>(select(0i, _e2264, (_e2264 > 0i)))];
let _e2270 = local_3;
let _e2271 = local_2;
let _e2272 = (_e2270 + _e2271);
let _e2274 = select(_e2262, _e2272, (_e2272 < _e2262));
let _e2279 = global_4.member[bitcast<u32>(select(0i, _e2274, (_e2274 > 0i)))];
let _e2280 = local_3;
let _e2282 = local_2;
let _e2283 = ((2i * _e2280) + _e2282);
let _e2285 = select(_e2262, _e2283, (_e2283 < _e2262));
let _e2290 = global_4.member[bitcast<u32>(select(0i, _e2285, (_e2285 > 0i)))];
let _e2291 = local_3;
let _e2293 = local_2;
let _e2294 = ((3i * _e2291) + _e2293);
let _e2296 = select(_e2262, _e2294, (_e2294 < _e2262));
let _e2301 = global_4.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2302 = bitcast<i32>(_e2227);
let _e2303 = f32(_e2302);
let _e2306 = global_1.member.member_1.member_1;
let _e2307 = bitcast<i32>(_e2306);
let _e2308 = f32(_e2307);
let _e2315 = global_1.member.member_2.member;
let _e2316 = (((((select(_e1168, _e2220, _e693) + 0.5f) / _e2303) * 2f) - 1f) * _e2315);
let _e2323 = global_1.member.member_2.member_1;
let _e2324 = ((1f - (((select(_e2220, _e1168, _e693) + 0.5f) / _e2308) * 2f)) * _e2323);
let _e2326 = global_1.member.member_3;
let _e2334 = global_1.member.member_4;
let _e2341 = ((_e2326.member * _e2316) + (_e2334.member * _e2324));
let _e2342 = ((_e2326.member_1 * _e2316) + (_e2334.member_1 * _e2324));
let _e2343 = ((_e2326.member_2 * _e2316) + (_e2334.member_2 * _e2324));
let _e2346 = global_1.member.member_2.member_3;
let _e2347 = (_e2346 != 0u);
let _e2349 = global_1.member.member_5;
let _e2356 = select((_e2349.member + _e2341), _e2349.member, _e2347);
let _e2357 = select((_e2349.member_1 + _e2342), _e2349.member_1, _e2347);
let _e2358 = select((_e2349.member_2 + _e2343), _e2349.member_2, _e2347);
let _e2360 = global_1.member.member_6;
let _e2374 = (((_e2356 * _e2356) + (_e2357 * _e2357)) + (_e2358 * _e2358));
let _e2377 = sqrt(select(0f, _e2374, (_e2374 > 0f)));
let _e2378 = (1f / _e2377);
let _e2379 = (_e2356 * _e2378);
let _e2380 = (_e2357 * _e2378);
let _e2381 = (_e2358 * _e2378);
let _e2382 = (_e180 - select(_e2360.member, (_e2360.member + _e2341), _e2347));
let _e2383 = (_e192 - select(_e2360.member_1, (_e2360.member_1 + _e2342), _e2347));
let _e2384 = (_e205 - select(_e2360.member_2, (_e2360.member_2 + _e2343), _e2347));
let _e2389 = (((_e2382 * _e2379) + (_e2383 * _e2380)) + (_e2384 * _e2381));
let _e2394 = (((_e2382 * _e218) + (_e2383 * _e231)) + (_e2384 * _e244));
let _e2399 = (((_e2379 * _e218) + (_e2380 * _e231)) + (_e2381 * _e244));
let _e2402 = ((_e2380 * _e244) - (_e2381 * _e231));
let _e2405 = ((_e2381 * _e218) - (_e2379 * _e244));
let _e2408 = ((_e2379 * _e231) - (_e2380 * _e218));
let _e2413 = (((_e2402 * _e2402) + (_e2405 * _e2405)) + (_e2408 * _e2408));
let _e2416 = (1f / select(1e-9f, _e2413, (_e2413 > 1e-9f)));
let _e2419 = ((_e2389 - (_e2399 * _e2394)) * _e2416);
let _e2422 = (((_e2399 * _e2389) - _e2394) * _e2416);
let _e2428 = (_e2419 - _e2301);
let _e2431 = (_e2422 + select(0f, _e2428, (_e2428 > 0f)));
let _e2434 = global_1.member.member_13.member;
let _e2439 = -((_e2434.member * _e2431));
let _e2441 = select(-87f, _e2439, (_e2439 > -87f));
let _e2443 = select(88f, _e2441, (_e2441 < 88f));
let _e2445 = ((_e2443 * 1.442695f) + 0.5f);
let _e2447 = select(-127f, _e2445, (_e2445 > -127f));
let _e2449 = select(128f, _e2447, (_e2447 < 128f));
let _e2456 = select(0i, select(select(i32(_e2449), i32(-2147483648), (_e2449 < -2147483600f)), 2147483647i, (_e2449 > 2147483500f)), (_e2449 == _e2449));
let _e2460 = (_e2456 - select(0i, 1i, (_e2449 < f32(_e2456))));
let _e2461 = f32(_e2460);
let _e2465 = ((_e2443 - (_e2461 * 0.6933594f)) - (_e2461 * -2.1219444e-4f));
let _e2487 = -((_e2434.member_1 * _e2431));
let _e2489 = select(-87f, _e2487, (_e2487 > -87f));
let _e2491 = select(88f, _e2489, (_e2489 < 88f));
let _e2493 = ((_e2491 * 1.442695f) + 0.5f);
let _e2495 = select(-127f, _e2493, (_e2493 > -127f));
let _e2497 = select(128f, _e2495, (_e2495 < 128f));
let _e2504 = select(0i, select(select(i32(_e2497), i32(-2147483648), (_e2497 < -2147483600f)), 2147483647i, (_e2497 > 2147483500f)), (_e2497 == _e2497));
let _e2508 = (_e2504 - select(0i, 1i, (_e2497 < f32(_e2504))));
let _e2509 = f32(_e2508);
let _e2513 = ((_e2491 - (_e2509 * 0.6933594f)) - (_e2509 * -2.1219444e-4f));
let _e2535 = -((_e2434.member_2 * _e2431));
let _e2537 = select(-87f, _e2535, (_e2535 > -87f));
let _e2539 = select(88f, _e2537, (_e2537 < 88f));
let _e2541 = ((_e2539 * 1.442695f) + 0.5f);
let _e2543 = select(-127f, _e2541, (_e2541 > -127f));
let _e2545 = select(128f, _e2543, (_e2543 < 128f));
let _e2552 = select(0i, select(select(i32(_e2545), i32(-2147483648), (_e2545 < -2147483600f)), 2147483647i, (_e2545 > 2147483500f)), (_e2545 == _e2545));
let _e2556 = (_e2552 - select(0i, 1i, (_e2545 < f32(_e2552))));
let _e2557 = f32(_e2556);
let _e2561 = ((_e2539 - (_e2557 * 0.6933594f)) - (_e2557 * -2.1219444e-4f));
let _e2582 = -(_e2399);
let _e2585 = global_1.member.member_13.member_2;
let _e2586 = (_e2585 * _e2585);
let _e2587 = (1f + _e2586);
let _e2588 = (2f * _e2585);
let _e2590 = (_e2587 - (_e2588 * _e2582));
let _e2592 = select(1e-9f, _e2590, (_e2590 > 1e-9f));
let _e2593 = (1f - _e2586);
let _e2604 = global_1.member.member_13.member_3;
let _e2605 = (_e2604 == 1u);
let _e2607 = (0.25f / 3.1415927f);
let _e2609 = (_e2377 * (select((_e2593 / (_e2592 * sqrt(select(0f, _e2592, (_e2592 > 0f))))), (0.75f * (1f + (_e2582 * _e2582))), _e2605) * _e2607));
let _e2612 = global_1.member.member_13.member_1;
let _e2616 = (_e413 * _e2612.member);
let _e2617 = (_e426 * _e2612.member_1);
let _e2618 = (_e439 * _e2612.member_2);
let _e2625 = select(0f, _e2419, (((_e2422 >= 0f) && (_e2422 < _e452)) && (_e2419 > 0f)));
if (_e2625 > _e2279) {
} else {
let _e2629 = ((_e2625 > 0f) && (_e2625 < _e2269));
if _e2629 {
let _e2631 = ((_e2220 - _e1172) * _e702);
let _e2632 = (_e702 * _e1142);
let _e2633 = (1e-4f * _e2632);
let _e2635 = select(_e1186, _e1179, (_e1179 > _e1186));
let _e2637 = select(_e2633, _e2635, (_e2635 > _e2633));
let _e2639 = select(_e1186, _e1179, (_e1179 < _e1186));
let _e2641 = select(_e2633, _e2639, (_e2639 > _e2633));
let _e2642 = (0.5f * _e2632);
let _e2643 = (_e2631 + _e2642);
let _e2644 = -(_e2643);
let _e2648 = (0.5f * (_e2637 + _e2641));
let _e2649 = (_e2648 - select(_e2644, _e2643, (_e2643 > _e2644)));
let _e2651 = select(0f, _e2649, (_e2649 > 0f));
let _e2653 = select(_e2641, _e2651, (_e2651 < _e2641));
let _e2657 = (_e2649 - _e2641);
let _e2661 = ((((_e2653 * (_e2653 / _e2641)) * 0.5f) + select(0f, _e2657, (_e2657 > 0f))) / _e2637);
let _e2665 = (_e2631 - _e2642);
let _e2666 = -(_e2665);
let _e2669 = (_e2648 - select(_e2666, _e2665, (_e2665 > _e2666)));
let _e2671 = select(0f, _e2669, (_e2669 > 0f));
let _e2673 = select(_e2641, _e2671, (_e2671 < _e2641));
let _e2677 = (_e2669 - _e2641);
let _e2681 = ((((_e2673 * (_e2673 / _e2641)) * 0.5f) + select(0f, _e2677, (_e2677 > 0f))) / _e2637);
let _e2686 = ((select(_e2661, (1f - _e2661), (_e2643 >= 0f)) - select(_e2681, (1f - _e2681), (_e2665 >= 0f))) / _e2632);
let _e2692 = global_1.member.member_18.member_2;
let _e2695 = global_1.member.member_18.member_3;
let _e2698 = global_1.member.member_18.member_4;
let _e2701 = global_1.member.member_18.member_5;
if _e1232 {
phi_4814_ = 0u;
} else {
if (_e984 == 1u) {
phi_4813_ = _e2692;
} else {
if (_e984 == 2u) {
phi_4812_ = _e2695;
} else {
phi_4812_ = select(_e2701, _e2698, (_e984 == 3u));
}
let _e2707 = phi_4812_;
phi_4813_ = _e2707;
}
let _e2709 = phi_4813_;
phi_4814_ = _e2709;
}
let _e2711 = phi_4814_;
let _e2723 = (((bitcast<i32>(_e2711) + (_e2224 * bitcast<i32>((((_e2227 + (1u << bitcast<u32>(_e1139))) - 1u) >> bitcast<u32>(_e1139))))) + _e2223) * 6i);
let _e2726 = global_1.member.member_18.member;
let _e2727 = ((((_e2616 * ((1f + (_e2465 * (1f + (_e2465 * (0.5f + (_e2465 * (0.16666667f + (_e2465 * (0.041666668f + (_e2465 * (0.008333334f + (_e2465 * (0.001388889f + (_e2465 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2460 + 127i)) << bitcast<u32>(23i))))) * _e2609) * _e2686) * _e2726);
if (bitcast<f32>((bitcast<u32>(_e2727) & 2147483647u)) < 1073741800f) {
let _e2733 = ((_e2727 * 1f) + 0.5f);
let _e2735 = select(-1073741800f, _e2733, (_e2733 > -1073741800f));
let _e2737 = select(1073741800f, _e2735, (_e2735 < 1073741800f));
let _e2744 = select(0i, select(select(i32(_e2737), i32(-2147483648), (_e2737 < -2147483600f)), 2147483647i, (_e2737 > 2147483500f)), (_e2737 == _e2737));
let _e2748 = (_e2744 - select(0i, 1i, (_e2737 < f32(_e2744))));
if (_e2748 == 0i) {
} else {
let _e2750 = bitcast<u32>(_e2748);
let _e2751 = bitcast<u32>(_e2723);
if (_e2751 < _e101) {
let _e2755 = atomicAdd((&global_5.member[_e2751]), _e2750);
phi_4881_ = _e2755;
} else {
phi_4881_ = 0u;
}
let _e2757 = phi_4881_;
let _e2764 = (bitcast<u32>((_e2748 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2757 + _e2750) < _e2750)));
if (_e2764 == 0u) {
} else {
let _e2766 = (_e2751 + 1u);
if (_e2766 < _e101) {
let _e2770 = atomicAdd((&global_5.member[_e2766]), _e2764);
}
}
}
} else {
let _e2773 = ((_e2727 * (1f / 1048576f)) + 0.5f);
let _e2775 = select(-1073741800f, _e2773, (_e2773 > -1073741800f));
let _e2777 = select(1073741800f, _e2775, (_e2775 < 1073741800f));
let _e2784 = select(0i, select(select(i32(_e2777), i32(-2147483648), (_e2777 < -2147483600f)), 2147483647i, (_e2777 > 2147483500f)), (_e2777 == _e2777));
let _e2788 = (_e2784 - select(0i, 1i, (_e2777 < f32(_e2784))));
let _e2791 = (bitcast<u32>(_e2788) << bitcast<u32>(20i));
let _e2792 = bitcast<u32>(_e2723);
if (_e2792 < _e101) {
let _e2796 = atomicAdd((&global_5.member[_e2792]), _e2791);
phi_4935_ = _e2796;
} else {
phi_4935_ = 0u;
}
let _e2798 = phi_4935_;
let _e2802 = (_e2792 + 1u);
if (_e2802 < _e101) {
let _e2810 = atomicAdd((&global_5.member[_e2802]), (bitcast<u32>((_e2788 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2798 + _e2791) < _e2791))));
}
}
let _e2811 = (_e2723 + 2i);
let _e2812 = ((((_e2617 * ((1f + (_e2513 * (1f + (_e2513 * (0.5f + (_e2513 * (0.16666667f + (_e2513 * (0.041666668f + (_e2513 * (0.008333334f + (_e2513 * (0.001388889f + (_e2513 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2508 + 127i)) << bitcast<u32>(23i))))) * _e2609) * _e2686) * _e2726);
if (bitcast<f32>((bitcast<u32>(_e2812) & 2147483647u)) < 1073741800f) {
let _e2818 = ((_e2812 * 1f) + 0.5f);
let _e2820 = select(-1073741800f, _e2818, (_e2818 > -1073741800f));
let _e2822 = select(1073741800f, _e2820, (_e2820 < 1073741800f));
let _e2829 = select(0i, select(select(i32(_e2822), i32(-2147483648), (_e2822 < -2147483600f)), 2147483647i, (_e2822 > 2147483500f)), (_e2822 == _e2822));
let _e2833 = (_e2829 - select(0i, 1i, (_e2822 < f32(_e2829))));
if (_e2833 == 0i) {
} else {
let _e2835 = bitcast<u32>(_e2833);
let _e2836 = bitcast<u32>(_e2811);
if (_e2836 < _e101) {
let _e2840 = atomicAdd((&global_5.member[_e2836]), _e2835);
phi_4999_ = _e2840;
} else {
phi_4999_ = 0u;
}
let _e2842 = phi_4999_;
let _e2849 = (bitcast<u32>((_e2833 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2842 + _e2835) < _e2835)));
if (_e2849 == 0u) {
} else {
let _e2851 = (_e2836 + 1u);
if (_e2851 < _e101) {
let _e2855 = atomicAdd((&global_5.member[_e2851]), _e2849);
}
}
}
} else {
let _e2858 = ((_e2812 * (1f / 1048576f)) + 0.5f);
let _e2860 = select(-1073741800f, _e2858, (_e2858 > -1073741800f));
let _e2862 = select(1073741800f, _e2860, (_e2860 < 1073741800f));
let _e2869 = select(0i, select(select(i32(_e2862), i32(-2147483648), (_e2862 < -2147483600f)), 2147483647i, (_e2862 > 2147483500f)), (_e2862 == _e2862));
let _e2873 = (_e2869 - select(0i, 1i, (_e2862 < f32(_e2869))));
let _e2876 = (bitcast<u32>(_e2873) << bitcast<u32>(20i));
let _e2877 = bitcast<u32>(_e2811);
if (_e2877 < _e101) {
let _e2881 = atomicAdd((&global_5.member[_e2877]), _e2876);
phi_5053_ = _e2881;
} else {
phi_5053_ = 0u;
}
let _e2883 = phi_5053_;
let _e2887 = (_e2877 + 1u);
if (_e2887 < _e101) {
let _e2895 = atomicAdd((&global_5.member[_e2887]), (bitcast<u32>((_e2873 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2883 + _e2876) < _e2876))));
}
}
let _e2896 = (_e2723 + 4i);
let _e2897 = ((((_e2618 * ((1f + (_e2561 * (1f + (_e2561 * (0.5f + (_e2561 * (0.16666667f + (_e2561 * (0.041666668f + (_e2561 * (0.008333334f + (_e2561 * (0.001388889f + (_e2561 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2556 + 127i)) << bitcast<u32>(23i))))) * _e2609) * _e2686) * _e2726);
if (bitcast<f32>((bitcast<u32>(_e2897) & 2147483647u)) < 1073741800f) {
let _e2903 = ((_e2897 * 1f) + 0.5f);
let _e2905 = select(-1073741800f, _e2903, (_e2903 > -1073741800f));
let _e2907 = select(1073741800f, _e2905, (_e2905 < 1073741800f));
let _e2914 = select(0i, select(select(i32(_e2907), i32(-2147483648), (_e2907 < -2147483600f)), 2147483647i, (_e2907 > 2147483500f)), (_e2907 == _e2907));
let _e2918 = (_e2914 - select(0i, 1i, (_e2907 < f32(_e2914))));
if (_e2918 == 0i) {
} else {
let _e2920 = bitcast<u32>(_e2918);
let _e2921 = bitcast<u32>(_e2896);
if (_e2921 < _e101) {
let _e2925 = atomicAdd((&global_5.member[_e2921]), _e2920);
phi_5117_ = _e2925;
} else {
phi_5117_ = 0u;
}
let _e2927 = phi_5117_;
let _e2934 = (bitcast<u32>((_e2918 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2927 + _e2920) < _e2920)));
if (_e2934 == 0u) {
} else {
let _e2936 = (_e2921 + 1u);
if (_e2936 < _e101) {
let _e2940 = atomicAdd((&global_5.member[_e2936]), _e2934);
}
}
}
} else {
let _e2943 = ((_e2897 * (1f / 1048576f)) + 0.5f);
let _e2945 = select(-1073741800f, _e2943, (_e2943 > -1073741800f));
let _e2947 = select(1073741800f, _e2945, (_e2945 < 1073741800f));
let _e2954 = select(0i, select(select(i32(_e2947), i32(-2147483648), (_e2947 < -2147483600f)), 2147483647i, (_e2947 > 2147483500f)), (_e2947 == _e2947));
let _e2958 = (_e2954 - select(0i, 1i, (_e2947 < f32(_e2954))));
let _e2961 = (bitcast<u32>(_e2958) << bitcast<u32>(20i));
let _e2962 = bitcast<u32>(_e2896);
if (_e2962 < _e101) {
let _e2966 = atomicAdd((&global_5.member[_e2962]), _e2961);
phi_5171_ = _e2966;
} else {
phi_5171_ = 0u;
}
let _e2968 = phi_5171_;
let _e2972 = (_e2962 + 1u);
if (_e2972 < _e101) {
let _e2980 = atomicAdd((&global_5.member[_e2972]), (bitcast<u32>((_e2958 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2968 + _e2961) < _e2961))));
}
}
}
let _e2981 = (_e1163 * _e1141);
let _e2984 = ((_e1163 + 1i) * _e1141);
let _e2987 = (_e1061 == _e984);
let _e2990 = (_e1138 == _e984);
if ((_e2629 && ((!((_e2981 == _e892)) || _e2987) && (!((_e2984 == _e893)) || _e2990))) && ((_e2625 * (1f + (0.02f * _e1142))) < _e2290)) {
} else {
phi_5232_ = _e2981;
loop {
let _e3002 = phi_5232_;
let _e3005 = ((_e3002 < _e2984) && (_e3002 < select(_e2302, _e2307, _e693)));
if _e3005 {
let _e3006 = f32(_e3002);
let _e3010 = (-(((_e694 * _e3006) + _e574)) / _e695);
let _e3017 = bitcast<f32>((bitcast<u32>(((_e696 * _e3006) + ((_e697 * _e3010) + _e630))) & 2147483647u));
let _e3024 = bitcast<f32>((bitcast<u32>(((_e698 * _e3006) + ((_e699 * _e3010) + _e686))) & 2147483647u));
phi_5275_ = (_e1252 * _e1141);
loop {
let _e3027 = phi_5275_;
let _e3032 = ((_e3027 < ((_e1252 + 1i) * _e1141)) && (_e3027 < select(_e2307, _e2302, _e693)));
if _e3032 {
phi_5289_ = 0u;
phi_5292_ = 1f;
loop {
let _e3034 = phi_5289_;
let _e3036 = phi_5292_;
local_15 = _e3036;
local_16 = _e3036;
let _e3037 = (_e3034 < 3u);
if _e3037 {
if (_e3034 == 0u) {
phi_5330_ = _e984;
} else {
if (_e3034 == 1u) {
phi_5329_ = select(_e1061, 0u, _e2987);
} else {
phi_5329_ = select(_e1138, 0u, (_e2990 || (_e1138 == _e1061)));
}
let _e3045 = phi_5329_;
phi_5330_ = _e3045;
}
let _e3047 = phi_5330_;
if (_e3047 > 0u) {
let _e3049 = (_e3047 & 31u);
let _e3051 = (1u << bitcast<u32>(_e3049));
let _e3055 = (((_e2227 + _e3051) - 1u) >> bitcast<u32>(_e3049));
let _e3059 = (((_e2306 + _e3051) - 1u) >> bitcast<u32>(_e3049));
if _e693 {
phi_5361_ = bitcast<i32>(_e3055);
phi_5362_ = bitcast<i32>(_e3059);
} else {
phi_5361_ = bitcast<i32>(_e3059);
phi_5362_ = bitcast<i32>(_e3055);
}
let _e3065 = phi_5361_;
let _e3067 = phi_5362_;
let _e3070 = f32((1i << bitcast<u32>(_e3049)));
let _e3071 = (1f / _e3070);
let _e3074 = (((_e3006 + 0.5f) * _e3071) - 0.5f);
let _e3078 = (((f32(_e3027) + 0.5f) * _e3071) - 0.5f);
let _e3080 = select(-1f, _e3074, (_e3074 > -1f));
let _e3082 = select(1e6f, _e3080, (_e3080 < 1e6f));
let _e3089 = select(0i, select(select(i32(_e3082), i32(-2147483648), (_e3082 < -2147483600f)), 2147483647i, (_e3082 > 2147483500f)), (_e3082 == _e3082));
let _e3093 = (_e3089 - select(0i, 1i, (_e3082 < f32(_e3089))));
let _e3095 = select(-1f, _e3078, (_e3078 > -1f));
let _e3097 = select(1e6f, _e3095, (_e3095 < 1e6f));
let _e3104 = select(0i, select(select(i32(_e3097), i32(-2147483648), (_e3097 < -2147483600f)), 2147483647i, (_e3097 > 2147483500f)), (_e3097 == _e3097));
let _e3108 = (_e3104 - select(0i, 1i, (_e3097 < f32(_e3104))));
let _e3110 = (_e3074 - f32(_e3093));
let _e3112 = (_e3078 - f32(_e3108));
phi_5426_ = 0i;
phi_5429_ = _e3036;
loop {
let _e3114 = phi_5426_;
let _e3116 = phi_5429_;
local_25 = _e3116;
let _e3117 = (_e3114 < 4i);
if _e3117 {
let _e3118 = (_e3114 & 1i);
let _e3119 = (_e3093 + _e3118);
let _e3121 = (_e3114 >> bitcast<u32>(1i));
let _e3122 = (_e3108 + _e3121);
if (_e3119 < _e3067) {
phi_5461_ = _e3119;
} else {
phi_5461_ = (_e3067 - 1i);
}
let _e3133 = phi_5461_;
let _e3135 = select(0i, _e3133, (_e3133 > 0i));
if (_e3122 < _e3065) {
phi_5472_ = _e3122;
} else {
phi_5472_ = (_e3065 - 1i);
}
let _e3139 = phi_5472_;
let _e3141 = select(0i, _e3139, (_e3139 > 0i));
let _e3145 = (((f32(_e3135) + 0.5f) * _e3070) - 0.5f);
let _e3149 = (((f32(_e3141) + 0.5f) * _e3070) - 0.5f);
if (_e3047 == 0u) {
phi_5553_ = 0u;
} else {
if (_e3047 == 1u) {
phi_5552_ = 0u;
} else {
if (_e3047 == 2u) {
phi_5551_ = _e2239;
} else {
phi_5551_ = select(_e2245, _e2242, (_e3047 == 3u));
}
let _e3160 = phi_5551_;
phi_5552_ = _e3160;
}
let _e3162 = phi_5552_;
phi_5553_ = _e3162;
}
let _e3164 = phi_5553_;
local = (((bitcast<i32>(_e3164) + select(_e3141, _e3135, _e693)) * _e2231) + select(_e3135, _e3141, _e693));
let _e3169 = local;
let _e3171 = select(_e2262, _e3169, (_e3169 < _e2262));
let _e3176 = global_4.member[bitcast<u32>(select(0i, _e3171, (_e3171 > 0i)))];
let _e3181 = (((((select(_e3145, _e3149, _e693) + 0.5f) / _e2303) * 2f) - 1f) * _e2315);
let _e3186 = ((1f - (((select(_e3149, _e3145, _e693) + 0.5f) / _e2308) * 2f)) * _e2323);
let _e3193 = ((_e2326.member * _e3181) + (_e2334.member * _e3186));
let _e3194 = ((_e2326.member_1 * _e3181) + (_e2334.member_1 * _e3186));
let _e3195 = ((_e2326.member_2 * _e3181) + (_e2334.member_2 * _e3186));
let _e3199 = select((_e2349.member + _e3193), _e2349.member, _e2347);
let _e3200 = select((_e2349.member_1 + _e3194), _e2349.member_1, _e2347);
let _e3201 = select((_e2349.member_2 + _e3195), _e2349.member_2, _e2347);
let _e3212 = (((_e3199 * _e3199) + (_e3200 * _e3200)) + (_e3201 * _e3201));
let _e3216 = (1f / sqrt(select(0f, _e3212, (_e3212 > 0f))));
let _e3217 = (_e3199 * _e3216);
let _e3218 = (_e3200 * _e3216);
let _e3219 = (_e3201 * _e3216);
let _e3220 = (_e180 - select(_e2360.member, (_e2360.member + _e3193), _e2347));
let _e3221 = (_e192 - select(_e2360.member_1, (_e2360.member_1 + _e3194), _e2347));
let _e3222 = (_e205 - select(_e2360.member_2, (_e2360.member_2 + _e3195), _e2347));
let _e3227 = (((_e3220 * _e3217) + (_e3221 * _e3218)) + (_e3222 * _e3219));
let _e3232 = (((_e3220 * _e218) + (_e3221 * _e231)) + (_e3222 * _e244));
let _e3237 = (((_e3217 * _e218) + (_e3218 * _e231)) + (_e3219 * _e244));
let _e3240 = ((_e3218 * _e244) - (_e3219 * _e231));
let _e3243 = ((_e3219 * _e218) - (_e3217 * _e244));
let _e3246 = ((_e3217 * _e231) - (_e3218 * _e218));
let _e3251 = (((_e3240 * _e3240) + (_e3243 * _e3243)) + (_e3246 * _e3246));
let _e3254 = (1f / select(1e-9f, _e3251, (_e3251 > 1e-9f)));
let _e3257 = ((_e3227 - (_e3237 * _e3232)) * _e3254);
let _e3260 = (((_e3237 * _e3227) - _e3232) * _e3254);
let _e3266 = select(0f, _e3257, (((_e3260 >= 0f) && (_e3260 < _e452)) && (_e3257 > 0f)));
let _e3268 = (_e3135 << bitcast<u32>(_e3049));
if (_e3268 < _e892) {
phi_5948_ = _e1061;
} else {
phi_5948_ = select(_e984, _e1138, (_e3268 >= _e893));
}
let _e3273 = phi_5948_;
if (((_e3273 == _e3047) && (_e3266 > 0f)) && (_e3266 < _e3176)) {
phi_5958_ = (_e3116 - (select((1f - _e3110), _e3110, (_e3118 == 1i)) * select((1f - _e3112), _e3112, (_e3121 == 1i))));
} else {
phi_5958_ = _e3116;
}
let _e3281 = phi_5958_;
phi_5427_ = (_e3114 + 1i);
phi_5430_ = _e3281;
} else {
phi_5427_ = i32();
phi_5430_ = f32();
}
let _e3284 = phi_5427_;
let _e3286 = phi_5430_;
continue;
continuing {
phi_5426_ = _e3284;
phi_5429_ = _e3286;
break if !(_e3117);
}
}
let _e4039 = local_25;
phi_5960_ = _e4039;
} else {
phi_5960_ = _e3036;
}
let _e3289 = phi_5960_;
phi_5290_ = (_e3034 + 1u);
phi_5293_ = _e3289;
} else {
phi_5290_ = u32();
phi_5293_ = f32();
}
let _e3292 = phi_5290_;
let _e3294 = phi_5293_;
continue;
continuing {
phi_5289_ = _e3292;
phi_5292_ = _e3294;
break if !(_e3037);
}
}
let _e3297 = local_15;
if (bitcast<f32>((bitcast<u32>(_e3297) & 2147483647u)) > 1e-6f) {
let _e3302 = select(_e3002, _e3027, _e693);
let _e3303 = select(_e3027, _e3002, _e693);
let _e3307 = ((_e3303 * _e2302) + _e3302);
let _e3309 = (bitcast<i32>(_e96) - 1i);
let _e3311 = select(_e3309, _e3307, (_e3307 < _e3309));
let _e3316 = global_3.member[bitcast<u32>(select(0i, _e3311, (_e3311 > 0i)))];
let _e3317 = (bitcast<i32>((_e2227 * _e2306)) + _e3307);
let _e3319 = select(_e3309, _e3317, (_e3317 < _e3309));
let _e3324 = global_3.member[bitcast<u32>(select(0i, _e3319, (_e3319 > 0i)))];
let _e3331 = (((((f32(_e3302) + 0.5f) / _e2303) * 2f) - 1f) * _e2315);
let _e3336 = ((1f - (((f32(_e3303) + 0.5f) / _e2308) * 2f)) * _e2323);
let _e3343 = ((_e2326.member * _e3331) + (_e2334.member * _e3336));
let _e3344 = ((_e2326.member_1 * _e3331) + (_e2334.member_1 * _e3336));
let _e3345 = ((_e2326.member_2 * _e3331) + (_e2334.member_2 * _e3336));
let _e3349 = select((_e2349.member + _e3343), _e2349.member, _e2347);
let _e3350 = select((_e2349.member_1 + _e3344), _e2349.member_1, _e2347);
let _e3351 = select((_e2349.member_2 + _e3345), _e2349.member_2, _e2347);
let _e3362 = (((_e3349 * _e3349) + (_e3350 * _e3350)) + (_e3351 * _e3351));
let _e3365 = sqrt(select(0f, _e3362, (_e3362 > 0f)));
let _e3366 = (1f / _e3365);
let _e3367 = (_e3349 * _e3366);
let _e3368 = (_e3350 * _e3366);
let _e3369 = (_e3351 * _e3366);
let _e3370 = (_e180 - select(_e2360.member, (_e2360.member + _e3343), _e2347));
let _e3371 = (_e192 - select(_e2360.member_1, (_e2360.member_1 + _e3344), _e2347));
let _e3372 = (_e205 - select(_e2360.member_2, (_e2360.member_2 + _e3345), _e2347));
let _e3377 = (((_e3370 * _e3367) + (_e3371 * _e3368)) + (_e3372 * _e3369));
let _e3382 = (((_e3370 * _e218) + (_e3371 * _e231)) + (_e3372 * _e244));
let _e3387 = (((_e3367 * _e218) + (_e3368 * _e231)) + (_e3369 * _e244));
let _e3390 = ((_e3368 * _e244) - (_e3369 * _e231));
let _e3393 = ((_e3369 * _e218) - (_e3367 * _e244));
let _e3396 = ((_e3367 * _e231) - (_e3368 * _e218));
let _e3401 = (((_e3390 * _e3390) + (_e3393 * _e3393)) + (_e3396 * _e3396));
let _e3404 = (1f / select(1e-9f, _e3401, (_e3401 > 1e-9f)));
let _e3407 = ((_e3377 - (_e3387 * _e3382)) * _e3404);
let _e3410 = (((_e3387 * _e3377) - _e3382) * _e3404);
let _e3416 = (_e3407 - _e3324);
let _e3419 = (_e3410 + select(0f, _e3416, (_e3416 > 0f)));
let _e3421 = -((_e2434.member * _e3419));
let _e3423 = select(-87f, _e3421, (_e3421 > -87f));
let _e3425 = select(88f, _e3423, (_e3423 < 88f));
let _e3427 = ((_e3425 * 1.442695f) + 0.5f);
let _e3429 = select(-127f, _e3427, (_e3427 > -127f));
let _e3431 = select(128f, _e3429, (_e3429 < 128f));
let _e3438 = select(0i, select(select(i32(_e3431), i32(-2147483648), (_e3431 < -2147483600f)), 2147483647i, (_e3431 > 2147483500f)), (_e3431 == _e3431));
let _e3442 = (_e3438 - select(0i, 1i, (_e3431 < f32(_e3438))));
let _e3443 = f32(_e3442);
let _e3447 = ((_e3425 - (_e3443 * 0.6933594f)) - (_e3443 * -2.1219444e-4f));
let _e3469 = -((_e2434.member_1 * _e3419));
let _e3471 = select(-87f, _e3469, (_e3469 > -87f));
let _e3473 = select(88f, _e3471, (_e3471 < 88f));
let _e3475 = ((_e3473 * 1.442695f) + 0.5f);
let _e3477 = select(-127f, _e3475, (_e3475 > -127f));
let _e3479 = select(128f, _e3477, (_e3477 < 128f));
let _e3486 = select(0i, select(select(i32(_e3479), i32(-2147483648), (_e3479 < -2147483600f)), 2147483647i, (_e3479 > 2147483500f)), (_e3479 == _e3479));
let _e3490 = (_e3486 - select(0i, 1i, (_e3479 < f32(_e3486))));
let _e3491 = f32(_e3490);
let _e3495 = ((_e3473 - (_e3491 * 0.6933594f)) - (_e3491 * -2.1219444e-4f));
let _e3517 = -((_e2434.member_2 * _e3419));
let _e3519 = select(-87f, _e3517, (_e3517 > -87f));
let _e3521 = select(88f, _e3519, (_e3519 < 88f));
let _e3523 = ((_e3521 * 1.442695f) + 0.5f);
let _e3525 = select(-127f, _e3523, (_e3523 > -127f));
let _e3527 = select(128f, _e3525, (_e3525 < 128f));
let _e3534 = select(0i, select(select(i32(_e3527), i32(-2147483648), (_e3527 < -2147483600f)), 2147483647i, (_e3527 > 2147483500f)), (_e3527 == _e3527));
let _e3538 = (_e3534 - select(0i, 1i, (_e3527 < f32(_e3534))));
let _e3539 = f32(_e3538);
let _e3543 = ((_e3521 - (_e3539 * 0.6933594f)) - (_e3539 * -2.1219444e-4f));
let _e3564 = -(_e3387);
let _e3566 = (_e2587 - (_e2588 * _e3564));
let _e3568 = select(1e-9f, _e3566, (_e3566 > 1e-9f));
let _e3579 = (_e3365 * (select((_e2593 / (_e3568 * sqrt(select(0f, _e3568, (_e3568 > 0f))))), (0.75f * (1f + (_e3564 * _e3564))), _e2605) * _e2607));
let _e3586 = select(0f, _e3407, (((_e3410 >= 0f) && (_e3410 < _e452)) && (_e3407 > 0f)));
if ((_e3586 > 0f) && (_e3586 < _e3316)) {
let _e3592 = ((f32(_e3027) - _e3010) * _e702);
let _e3593 = (_e702 * 1f);
let _e3594 = (1e-4f * _e3593);
let _e3596 = select(_e3024, _e3017, (_e3017 > _e3024));
let _e3598 = select(_e3594, _e3596, (_e3596 > _e3594));
let _e3600 = select(_e3024, _e3017, (_e3017 < _e3024));
let _e3602 = select(_e3594, _e3600, (_e3600 > _e3594));
let _e3603 = (0.5f * _e3593);
let _e3604 = (_e3592 + _e3603);
let _e3605 = -(_e3604);
let _e3609 = (0.5f * (_e3598 + _e3602));
let _e3610 = (_e3609 - select(_e3605, _e3604, (_e3604 > _e3605)));
let _e3612 = select(0f, _e3610, (_e3610 > 0f));
let _e3614 = select(_e3602, _e3612, (_e3612 < _e3602));
let _e3618 = (_e3610 - _e3602);
let _e3622 = ((((_e3614 * (_e3614 / _e3602)) * 0.5f) + select(0f, _e3618, (_e3618 > 0f))) / _e3598);
let _e3626 = (_e3592 - _e3603);
let _e3627 = -(_e3626);
let _e3630 = (_e3609 - select(_e3627, _e3626, (_e3626 > _e3627)));
let _e3632 = select(0f, _e3630, (_e3630 > 0f));
let _e3634 = select(_e3602, _e3632, (_e3632 < _e3602));
let _e3638 = (_e3630 - _e3602);
let _e3642 = ((((_e3634 * (_e3634 / _e3602)) * 0.5f) + select(0f, _e3638, (_e3638 > 0f))) / _e3598);
let _e3649 = local_16;
let _e3650 = (((select(_e3622, (1f - _e3622), (_e3604 >= 0f)) - select(_e3642, (1f - _e3642), (_e3626 >= 0f))) / _e3593) * _e3649);
let _e3654 = (_e3307 * 6i);
let _e3657 = global_1.member.member_18.member;
let _e3658 = ((((_e2616 * ((1f + (_e3447 * (1f + (_e3447 * (0.5f + (_e3447 * (0.16666667f + (_e3447 * (0.041666668f + (_e3447 * (0.008333334f + (_e3447 * (0.001388889f + (_e3447 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3442 + 127i)) << bitcast<u32>(23i))))) * _e3579) * _e3650) * _e3657);
if (bitcast<f32>((bitcast<u32>(_e3658) & 2147483647u)) < 1073741800f) {
let _e3664 = ((_e3658 * 1f) + 0.5f);
let _e3666 = select(-1073741800f, _e3664, (_e3664 > -1073741800f));
let _e3668 = select(1073741800f, _e3666, (_e3666 < 1073741800f));
let _e3675 = select(0i, select(select(i32(_e3668), i32(-2147483648), (_e3668 < -2147483600f)), 2147483647i, (_e3668 > 2147483500f)), (_e3668 == _e3668));
let _e3679 = (_e3675 - select(0i, 1i, (_e3668 < f32(_e3675))));
if (_e3679 == 0i) {
} else {
let _e3681 = bitcast<u32>(_e3679);
let _e3682 = bitcast<u32>(_e3654);
if (_e3682 < _e101) {
let _e3686 = atomicAdd((&global_5.member[_e3682]), _e3681);
phi_6686_ = _e3686;
} else {
phi_6686_ = 0u;
}
let _e3688 = phi_6686_;
let _e3695 = (bitcast<u32>((_e3679 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3688 + _e3681) < _e3681)));
if (_e3695 == 0u) {
} else {
let _e3697 = (_e3682 + 1u);
if (_e3697 < _e101) {
let _e3701 = atomicAdd((&global_5.member[_e3697]), _e3695);
}
}
}
} else {
let _e3704 = ((_e3658 * (1f / 1048576f)) + 0.5f);
let _e3706 = select(-1073741800f, _e3704, (_e3704 > -1073741800f));
let _e3708 = select(1073741800f, _e3706, (_e3706 < 1073741800f));
let _e3715 = select(0i, select(select(i32(_e3708), i32(-2147483648), (_e3708 < -2147483600f)), 2147483647i, (_e3708 > 2147483500f)), (_e3708 == _e3708));
let _e3719 = (_e3715 - select(0i, 1i, (_e3708 < f32(_e3715))));
let _e3722 = (bitcast<u32>(_e3719) << bitcast<u32>(20i));
let _e3723 = bitcast<u32>(_e3654);
if (_e3723 < _e101) {
let _e3727 = atomicAdd((&global_5.member[_e3723]), _e3722);
phi_6740_ = _e3727;
} else {
phi_6740_ = 0u;
}
let _e3729 = phi_6740_;
let _e3733 = (_e3723 + 1u);
if (_e3733 < _e101) {
let _e3741 = atomicAdd((&global_5.member[_e3733]), (bitcast<u32>((_e3719 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3729 + _e3722) < _e3722))));
}
}
let _e3742 = (_e3654 + 2i);
let _e3743 = ((((_e2617 * ((1f + (_e3495 * (1f + (_e3495 * (0.5f + (_e3495 * (0.16666667f + (_e3495 * (0.041666668f + (_e3495 * (0.008333334f + (_e3495 * (0.001388889f + (_e3495 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3490 + 127i)) << bitcast<u32>(23i))))) * _e3579) * _e3650) * _e3657);
if (bitcast<f32>((bitcast<u32>(_e3743) & 2147483647u)) < 1073741800f) {
let _e3749 = ((_e3743 * 1f) + 0.5f);
let _e3751 = select(-1073741800f, _e3749, (_e3749 > -1073741800f));
let _e3753 = select(1073741800f, _e3751, (_e3751 < 1073741800f));
let _e3760 = select(0i, select(select(i32(_e3753), i32(-2147483648), (_e3753 < -2147483600f)), 2147483647i, (_e3753 > 2147483500f)), (_e3753 == _e3753));
let _e3764 = (_e3760 - select(0i, 1i, (_e3753 < f32(_e3760))));
if (_e3764 == 0i) {
} else {
let _e3766 = bitcast<u32>(_e3764);
let _e3767 = bitcast<u32>(_e3742);
if (_e3767 < _e101) {
let _e3771 = atomicAdd((&global_5.member[_e3767]), _e3766);
phi_6804_ = _e3771;
} else {
phi_6804_ = 0u;
}
let _e3773 = phi_6804_;
let _e3780 = (bitcast<u32>((_e3764 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3773 + _e3766) < _e3766)));
if (_e3780 == 0u) {
} else {
let _e3782 = (_e3767 + 1u);
if (_e3782 < _e101) {
let _e3786 = atomicAdd((&global_5.member[_e3782]), _e3780);
}
}
}
} else {
let _e3789 = ((_e3743 * (1f / 1048576f)) + 0.5f);
let _e3791 = select(-1073741800f, _e3789, (_e3789 > -1073741800f));
let _e3793 = select(1073741800f, _e3791, (_e3791 < 1073741800f));
let _e3800 = select(0i, select(select(i32(_e3793), i32(-2147483648), (_e3793 < -2147483600f)), 2147483647i, (_e3793 > 2147483500f)), (_e3793 == _e3793));
let _e3804 = (_e3800 - select(0i, 1i, (_e3793 < f32(_e3800))));
let _e3807 = (bitcast<u32>(_e3804) << bitcast<u32>(20i));
let _e3808 = bitcast<u32>(_e3742);
if (_e3808 < _e101) {
let _e3812 = atomicAdd((&global_5.member[_e3808]), _e3807);
phi_6858_ = _e3812;
} else {
phi_6858_ = 0u;
}
let _e3814 = phi_6858_;
let _e3818 = (_e3808 + 1u);
if (_e3818 < _e101) {
let _e3826 = atomicAdd((&global_5.member[_e3818]), (bitcast<u32>((_e3804 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3814 + _e3807) < _e3807))));
}
}
let _e3827 = (_e3654 + 4i);
let _e3828 = ((((_e2618 * ((1f + (_e3543 * (1f + (_e3543 * (0.5f + (_e3543 * (0.16666667f + (_e3543 * (0.041666668f + (_e3543 * (0.008333334f + (_e3543 * (0.001388889f + (_e3543 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3538 + 127i)) << bitcast<u32>(23i))))) * _e3579) * _e3650) * _e3657);
if (bitcast<f32>((bitcast<u32>(_e3828) & 2147483647u)) < 1073741800f) {
let _e3834 = ((_e3828 * 1f) + 0.5f);
let _e3836 = select(-1073741800f, _e3834, (_e3834 > -1073741800f));
let _e3838 = select(1073741800f, _e3836, (_e3836 < 1073741800f));
let _e3845 = select(0i, select(select(i32(_e3838), i32(-2147483648), (_e3838 < -2147483600f)), 2147483647i, (_e3838 > 2147483500f)), (_e3838 == _e3838));
let _e3849 = (_e3845 - select(0i, 1i, (_e3838 < f32(_e3845))));
if (_e3849 == 0i) {
} else {
let _e3851 = bitcast<u32>(_e3849);
let _e3852 = bitcast<u32>(_e3827);
if (_e3852 < _e101) {
let _e3856 = atomicAdd((&global_5.member[_e3852]), _e3851);
phi_6922_ = _e3856;
} else {
phi_6922_ = 0u;
}
let _e3858 = phi_6922_;
let _e3865 = (bitcast<u32>((_e3849 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3858 + _e3851) < _e3851)));
if (_e3865 == 0u) {
} else {
let _e3867 = (_e3852 + 1u);
if (_e3867 < _e101) {
let _e3871 = atomicAdd((&global_5.member[_e3867]), _e3865);
}
}
}
} else {
let _e3874 = ((_e3828 * (1f / 1048576f)) + 0.5f);
let _e3876 = select(-1073741800f, _e3874, (_e3874 > -1073741800f));
let _e3878 = select(1073741800f, _e3876, (_e3876 < 1073741800f));
let _e3885 = select(0i, select(select(i32(_e3878), i32(-2147483648), (_e3878 < -2147483600f)), 2147483647i, (_e3878 > 2147483500f)), (_e3878 == _e3878));
let _e3889 = (_e3885 - select(0i, 1i, (_e3878 < f32(_e3885))));
let _e3892 = (bitcast<u32>(_e3889) << bitcast<u32>(20i));
let _e3893 = bitcast<u32>(_e3827);
if (_e3893 < _e101) {
let _e3897 = atomicAdd((&global_5.member[_e3893]), _e3892);
phi_6976_ = _e3897;
} else {
phi_6976_ = 0u;
}
let _e3899 = phi_6976_;
let _e3903 = (_e3893 + 1u);
if (_e3903 < _e101) {
let _e3911 = atomicAdd((&global_5.member[_e3903]), (bitcast<u32>((_e3889 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e3899 + _e3892) < _e3892))));
}
}
}
}
phi_5276_ = (_e3027 + 1i);
} else {
phi_5276_ = i32();
}
let _e3914 = phi_5276_;
continue;
continuing {
phi_5275_ = _e3914;
break if !(_e3032);
}
}
phi_5233_ = (_e3002 + 1i);
} else {
phi_5233_ = i32();
}
let _e3918 = phi_5233_;
continue;
continuing {
phi_5232_ = _e3918;
break if !(_e3005);
}
}
}
}
}
phi_2325_ = (_e1252 + 1i);
} else {
phi_2325_ = i32();
}
let _e3922 = phi_2325_;
continue;
continuing {
phi_2324_ = _e3922;
break if !(_e1253);
}
}
phi_2222_ = (_e1163 + 1i);
} else {
phi_2222_ = i32();
}
let _e3926 = phi_2222_;
continue;
continuing {
phi_2221_ = _e3926;
break if !(_e1164);
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
