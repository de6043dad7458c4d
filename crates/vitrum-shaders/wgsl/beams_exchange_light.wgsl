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
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_19 {
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
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_21 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_22 {
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
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_24 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_22,
member_19: type_23,
}
struct type_25 {
member: type_24,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage> global_1: type_15;
@group(0) @binding(4)
var<storage, read_write> global_2: type_15;
@group(0) @binding(0)
var<storage> global_3: type_25;
@group(0) @binding(1)
var<storage> global_4: type_15;
@group(0) @binding(2)
var<storage> global_5: type_15;
fn function_() {
var local: array<f32, 6>;
var local_1: array<f32, 6>;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: array<f32, 6>;
var local_6: array<f32, 6>;
var local_7: array<f32, 6>;
var local_8: array<f32, 6>;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: array<f32, 6>;
var local_13: array<f32, 6>;
var local_14: i32;
var phi_2884_: bool;
var phi_466_: u32;
var phi_2883_: bool;
var phi_476_: u32;
var phi_1000_: i32;
var phi_1011_: i32;
var phi_1023_: i32;
var phi_1520_: f32;
var phi_1541_: u32;
var phi_1542_: u32;
var phi_2801_: bool;
var phi_2886_: bool;
var phi_477_: u32;
var phi_2885_: bool;
var phi_1585_: u32;
var phi_1586_: u32;
var phi_2887_: bool;
var phi_2891_: bool;
var phi_467_: u32;
var phi_2890_: bool;
var phi_2786_: bool;
var phi_1622_: u32;
var phi_2785_: bool;
var phi_1632_: u32;
var phi_2156_: i32;
var phi_2167_: i32;
var phi_2179_: i32;
var phi_2535_: u32;
var phi_2536_: u32;
var phi_2718_: bool;
var phi_2795_: bool;
var phi_1633_: u32;
var phi_2794_: bool;
var phi_2579_: u32;
var phi_2580_: u32;
var phi_2796_: bool;
var phi_2800_: bool;
var phi_1623_: u32;
var phi_2799_: bool;
var phi_2615_: array<f32, 6>;
switch bitcast<i32>(0u) {
default: {
let _e77 = global;
let _e84 = arrayLength((&global_5.member));
let _e87 = arrayLength((&global_1.member));
let _e90 = global_3.member.member;
if (_e77.x < _e90.member) {
if (_e77.y < _e90.member_1) {
let _e97 = (_e90.member * _e90.member_1);
let _e99 = ((_e77.y * _e90.member) + _e77.x);
let _e101 = (_e77.y % 16u);
let _e102 = (_e77.y / 16u);
let _e112 = global_3.member.member_13.member_4;
let _e119 = global_3.member.member_19.member;
let _e126 = (_e112.member + ((f32(_e77.x) + 0.5f) * _e119.member));
let _e127 = (_e112.member_1 + ((f32(_e101) + 0.5f) * _e119.member_1));
let _e128 = (_e112.member_2 + ((f32(_e102) + 0.5f) * _e119.member_2));
local_14 = bitcast<i32>(((_e77.y * 16u) + _e77.x));
let _e132 = local_14;
let _e133 = (28672i + _e132);
let _e135 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e137 = select(_e135, _e133, (_e133 < _e135));
let _e142 = global_4.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = global_3.member.member_6;
let _e149 = (_e145.member - _e126);
let _e150 = (_e145.member_1 - _e127);
let _e151 = (_e145.member_2 - _e128);
let _e155 = global_3.member.member_2.member_3;
let _e156 = (_e155 != 0u);
let _e159 = global_3.member.member_5;
let _e170 = (((_e149 * _e149) + (_e150 * _e150)) + (_e151 * _e151));
let _e173 = sqrt(select(0f, _e170, (_e170 > 0f)));
let _e176 = (1f / select(1e-20f, _e173, (_e173 > 1e-20f)));
if (_e90.member_2 == 1u) {
local_12 = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
phi_2884_ = false;
phi_466_ = 0u;
loop {
let _e185 = phi_2884_;
let _e187 = phi_466_;
let _e188 = (_e187 < 16u);
if _e188 {
local_13 = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
phi_2883_ = _e185;
phi_476_ = 0u;
loop {
let _e190 = phi_2883_;
let _e192 = phi_476_;
let _e193 = (_e192 < 256u);
if _e193 {
let _e194 = (_e192 % 16u);
let _e195 = (_e192 / 16u);
let _e198 = bitcast<i32>(((_e192 * 16u) + _e187));
let _e207 = global_3.member.member_13.member_4;
let _e213 = global_3.member.member_19.member;
let _e223 = (_e126 - (_e207.member + ((f32(_e187) + 0.5f) * _e213.member)));
let _e224 = (_e127 - (_e207.member_1 + ((f32(_e194) + 0.5f) * _e213.member_1)));
let _e225 = (_e128 - (_e207.member_2 + ((f32(_e195) + 0.5f) * _e213.member_2)));
let _e230 = (((_e187 == _e77.x) && (_e194 == _e101)) && (_e195 == _e102));
let _e235 = (((_e223 * _e223) + (_e224 * _e224)) + (_e225 * _e225));
let _e238 = sqrt(select(0f, _e235, (_e235 > 0f)));
let _e241 = (1f / select(1e-20f, _e238, (_e238 > 1e-20f)));
let _e242 = (_e223 * _e241);
let _e243 = (_e224 * _e241);
let _e244 = (_e225 * _e241);
local_10 = _e198;
let _e245 = local_10;
let _e247 = select(_e135, _e245, (_e245 < _e135));
let _e252 = global_4.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e253 = local_10;
let _e254 = (4096i + _e253);
let _e256 = select(_e135, _e254, (_e254 < _e135));
let _e261 = global_4.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e262 = local_10;
let _e263 = (8192i + _e262);
let _e265 = select(_e135, _e263, (_e263 < _e135));
let _e270 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e271 = local_10;
let _e272 = (12288i + _e271);
let _e274 = select(_e135, _e272, (_e272 < _e135));
let _e279 = global_4.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_10;
let _e281 = (16384i + _e280);
let _e283 = select(_e135, _e281, (_e281 < _e135));
let _e288 = global_4.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e289 = local_10;
let _e290 = (20480i + _e289);
let _e292 = select(_e135, _e290, (_e290 < _e135));
let _e297 = global_4.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e298 = local_10;
let _e299 = (24576i + _e298);
let _e301 = select(_e135, _e299, (_e299 < _e135));
let _e306 = global_4.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e307 = local_10;
let _e308 = (28672i + _e307);
let _e310 = select(_e135, _e308, (_e308 < _e135));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
local_9 = _e198;
let _e316 = local_9;
let _e318 = (bitcast<i32>(_e84) - 1i);
let _e320 = select(_e318, _e316, (_e316 < _e318));
let _e325 = global_5.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e326 = local_9;
let _e327 = (4096i + _e326);
let _e329 = select(_e318, _e327, (_e327 < _e318));
let _e334 = global_5.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e335 = local_9;
let _e336 = (8192i + _e335);
let _e338 = select(_e318, _e336, (_e336 < _e318));
let _e343 = global_5.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e344 = local_9;
let _e345 = (12288i + _e344);
let _e347 = select(_e318, _e345, (_e345 < _e318));
let _e352 = global_5.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e353 = local_9;
let _e354 = (16384i + _e353);
let _e356 = select(_e318, _e354, (_e354 < _e318));
let _e361 = global_5.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e362 = local_9;
let _e363 = (20480i + _e362);
let _e365 = select(_e318, _e363, (_e363 < _e318));
let _e370 = global_5.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e371 = local_9;
let _e372 = (24576i + _e371);
let _e374 = select(_e318, _e372, (_e372 < _e318));
let _e379 = global_5.member[bitcast<u32>(select(0i, _e374, (_e374 > 0i)))];
let _e380 = local_9;
let _e381 = (28672i + _e380);
let _e383 = select(_e318, _e381, (_e381 < _e318));
let _e388 = global_5.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e391 = global_3.member.member_19.member_2;
let _e393 = select((_e391 * _e306), 0f, _e230);
let _e399 = (_e393 * _e393);
let _e403 = ((1f + _e399) - ((2f * _e393) * (((_e279 * _e242) + (_e288 * _e243)) + (_e297 * _e244))));
let _e405 = select(1e-9f, _e403, (_e403 > 1e-9f));
let _e412 = (((1f - _e399) / (_e405 * sqrt(select(0f, _e405, (_e405 > 0f))))) * _e315);
let _e417 = select((_e391 * _e379), 0f, _e230);
let _e423 = (_e417 * _e417);
let _e427 = ((1f + _e423) - ((2f * _e417) * (((_e352 * _e242) + (_e361 * _e243)) + (_e370 * _e244))));
let _e429 = select(1e-9f, _e427, (_e427 > 1e-9f));
let _e436 = (((1f - _e423) / (_e429 * sqrt(select(0f, _e429, (_e429 > 0f))))) * _e388);
let _e445 = (bitcast<i32>(_e195) - bitcast<i32>(_e102));
if (_e445 < 0i) {
phi_1000_ = -(_e445);
} else {
phi_1000_ = _e445;
}
let _e449 = phi_1000_;
let _e453 = (bitcast<i32>(_e194) - bitcast<i32>(_e101));
if (_e453 < 0i) {
phi_1011_ = -(_e453);
} else {
phi_1011_ = _e453;
}
let _e457 = phi_1011_;
let _e462 = (bitcast<i32>(_e187) - bitcast<i32>(_e77.x));
if (_e462 < 0i) {
phi_1023_ = -(_e462);
} else {
phi_1023_ = _e462;
}
let _e466 = phi_1023_;
local_11 = ((((_e449 * 16i) + _e457) * 16i) + _e466);
let _e470 = global_3.member.member_19.member_3;
let _e471 = bitcast<i32>(_e470);
let _e472 = local_11;
let _e473 = (_e471 + _e472);
let _e475 = (bitcast<i32>(_e87) - 1i);
let _e477 = select(_e475, _e473, (_e473 < _e475));
let _e482 = global_1.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e484 = local_11;
let _e485 = ((_e471 + 4096i) + _e484);
let _e487 = select(_e475, _e485, (_e485 < _e475));
let _e492 = global_1.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e494 = local_11;
let _e495 = ((_e471 + 8192i) + _e494);
let _e497 = select(_e475, _e495, (_e495 < _e475));
let _e502 = global_1.member[bitcast<u32>(select(0i, _e497, (_e497 > 0i)))];
let _e507 = local_11;
let _e508 = ((_e471 + 12288i) + _e507);
let _e510 = select(_e475, _e508, (_e508 < _e475));
let _e515 = global_1.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e516 = (((0.5f * (_e315 + _e142)) - 1f) * _e515);
let _e519 = global_3.member.member_13.member;
let _e524 = -((_e519.member * _e516));
let _e526 = select(-87f, _e524, (_e524 > -87f));
let _e528 = select(88f, _e526, (_e526 < 88f));
let _e530 = ((_e528 * 1.442695f) + 0.5f);
let _e532 = select(-127f, _e530, (_e530 > -127f));
let _e534 = select(128f, _e532, (_e532 < 128f));
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e545 = (_e541 - select(0i, 1i, (_e534 < f32(_e541))));
let _e546 = f32(_e545);
let _e550 = ((_e528 - (_e546 * 0.6933594f)) - (_e546 * -2.1219444e-4f));
let _e572 = -((_e519.member_1 * _e516));
let _e574 = select(-87f, _e572, (_e572 > -87f));
let _e576 = select(88f, _e574, (_e574 < 88f));
let _e578 = ((_e576 * 1.442695f) + 0.5f);
let _e580 = select(-127f, _e578, (_e578 > -127f));
let _e582 = select(128f, _e580, (_e580 < 128f));
let _e589 = select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582));
let _e593 = (_e589 - select(0i, 1i, (_e582 < f32(_e589))));
let _e594 = f32(_e593);
let _e598 = ((_e576 - (_e594 * 0.6933594f)) - (_e594 * -2.1219444e-4f));
let _e620 = -((_e519.member_2 * _e516));
let _e622 = select(-87f, _e620, (_e620 > -87f));
let _e624 = select(88f, _e622, (_e622 < 88f));
let _e626 = ((_e624 * 1.442695f) + 0.5f);
let _e628 = select(-127f, _e626, (_e626 > -127f));
let _e630 = select(128f, _e628, (_e628 < 128f));
let _e637 = select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < -2147483600f)), 2147483647i, (_e630 > 2147483500f)), (_e630 == _e630));
let _e641 = (_e637 - select(0i, 1i, (_e630 < f32(_e637))));
let _e642 = f32(_e641);
let _e646 = ((_e624 - (_e642 * 0.6933594f)) - (_e642 * -2.1219444e-4f));
let _e670 = global_3.member.member_13.member_6;
let _e673 = select(vec3<f32>(((1f + (_e550 * (1f + (_e550 * (0.5f + (_e550 * (0.16666667f + (_e550 * (0.041666668f + (_e550 * (0.008333334f + (_e550 * (0.001388889f + (_e550 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e545 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e598 * (1f + (_e598 * (0.5f + (_e598 * (0.16666667f + (_e598 * (0.041666668f + (_e598 * (0.008333334f + (_e598 * (0.001388889f + (_e598 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e593 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e646 * (1f + (_e646 * (0.5f + (_e646 * (0.16666667f + (_e646 * (0.041666668f + (_e646 * (0.008333334f + (_e646 * (0.001388889f + (_e646 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e641 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(1f, 1f, 1f), vec3((_e670 == 0u)));
let _e685 = global_3.member.member_13.member_1;
let _e692 = (0.25f / 3.1415927f);
let _e700 = (((_e242 * select((_e149 * _e176), -(_e159.member), _e156)) + (_e243 * select((_e150 * _e176), -(_e159.member_1), _e156))) + (_e244 * select((_e151 * _e176), -(_e159.member_2), _e156)));
let _e703 = global_3.member.member_13.member_2;
let _e704 = (_e703 * _e703);
let _e708 = ((1f + _e704) - ((2f * _e703) * _e700));
let _e710 = select(1e-9f, _e708, (_e708 > 1e-9f));
let _e722 = global_3.member.member_13.member_3;
if (_e722 == 2u) {
let _e727 = (0.5f - (0.5f * _e700));
let _e729 = select(0f, _e727, (_e727 > 0f));
let _e733 = (sqrt(select(0f, _e729, (_e729 > 0f))) * 255f);
let _e734 = (255f - 1f);
let _e736 = select(0f, _e733, (_e733 > 0f));
let _e738 = select(_e734, _e736, (_e736 < _e734));
let _e745 = select(0i, select(select(i32(_e738), i32(-2147483648), (_e738 < -2147483600f)), 2147483647i, (_e738 > 2147483500f)), (_e738 == _e738));
let _e749 = (_e745 - select(0i, 1i, (_e738 < f32(_e745))));
let _e752 = global_3.member.member_13.member_11;
let _e753 = bitcast<i32>(_e752);
let _e754 = (_e753 + _e749);
let _e756 = select(_e475, _e754, (_e754 < _e475));
let _e761 = global_1.member[bitcast<u32>(select(0i, _e756, (_e756 > 0i)))];
let _e763 = (_e753 + (_e749 + 1i));
let _e765 = select(_e475, _e763, (_e763 < _e475));
let _e770 = global_1.member[bitcast<u32>(select(0i, _e765, (_e765 > 0i)))];
phi_1520_ = (_e761 + ((_e770 - _e761) * (_e733 - f32(_e749))));
} else {
phi_1520_ = select(((1f - _e704) / (_e710 * sqrt(select(0f, _e710, (_e710 > 0f))))), (0.75f * (1f + (_e700 * _e700))), (_e722 == 1u));
}
let _e777 = phi_1520_;
let _e780 = (3.1415927f * select((_e777 * _e692), _e692, _e230));
local_8 = array<f32, 6>((((((((_e252 * _e412) + (_e325 * _e436)) * _e482) * _e673.x) * _e685.member) * _e692) * _e780), (((((((_e261 * _e412) + (_e334 * _e436)) * _e492) * _e673.y) * _e685.member_1) * _e692) * _e780), (((((((_e270 * _e412) + (_e343 * _e436)) * _e502) * _e673.z) * _e685.member_2) * _e692) * _e780), 0f, 0f, 0f);
phi_1541_ = 0u;
loop {
let _e786 = phi_1541_;
let _e787 = (_e786 < 6u);
if _e787 {
if _e787 {
} else {
phi_2801_ = true;
break;
}
let _e789 = local_8[_e786];
if _e787 {
} else {
phi_2801_ = true;
break;
}
let _e791 = local_13[_e786];
local_13[_e786] = (_e791 + _e789);
phi_1542_ = (_e786 + 1u);
} else {
phi_1542_ = u32();
}
let _e795 = phi_1542_;
continue;
continuing {
phi_1541_ = _e795;
phi_2801_ = _e190;
break if !(_e787);
}
}
let _e798 = phi_2801_;
phi_2885_ = _e798;
if _e798 {
break;
}
phi_2886_ = _e798;
phi_477_ = (_e192 + 1u);
} else {
phi_2886_ = _e190;
phi_477_ = u32();
}
let _e801 = phi_2886_;
let _e803 = phi_477_;
continue;
continuing {
phi_2883_ = _e801;
phi_476_ = _e803;
phi_2885_ = _e801;
break if !(_e193);
}
}
let _e806 = phi_2885_;
phi_2890_ = _e806;
if _e806 {
break;
}
let _e807 = local_13;
local_7 = _e807;
phi_1585_ = 0u;
loop {
let _e809 = phi_1585_;
let _e810 = (_e809 < 6u);
if _e810 {
if _e810 {
} else {
phi_2887_ = true;
break;
}
let _e812 = local_7[_e809];
if _e810 {
} else {
phi_2887_ = true;
break;
}
let _e814 = local_12[_e809];
local_12[_e809] = (_e814 + _e812);
phi_1586_ = (_e809 + 1u);
} else {
phi_1586_ = u32();
}
let _e818 = phi_1586_;
continue;
continuing {
phi_1585_ = _e818;
phi_2887_ = _e806;
break if !(_e810);
}
}
let _e821 = phi_2887_;
phi_2890_ = _e821;
if _e821 {
break;
}
phi_2891_ = _e821;
phi_467_ = (_e187 + 1u);
} else {
phi_2891_ = _e185;
phi_467_ = u32();
}
let _e824 = phi_2891_;
let _e826 = phi_467_;
continue;
continuing {
phi_2884_ = _e824;
phi_466_ = _e826;
phi_2890_ = _e824;
break if !(_e188);
}
}
let _e829 = phi_2890_;
if _e829 {
break;
}
let _e830 = local_12;
phi_2615_ = array<f32, 6>(_e830[0], _e830[1], _e830[2], _e830[3], _e830[4], _e830[5]);
} else {
local_5 = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
phi_2786_ = false;
phi_1622_ = 0u;
loop {
let _e839 = phi_2786_;
let _e841 = phi_1622_;
let _e842 = (_e841 < 16u);
if _e842 {
local_6 = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
phi_2785_ = _e839;
phi_1632_ = 0u;
loop {
let _e844 = phi_2785_;
let _e846 = phi_1632_;
let _e847 = (_e846 < 256u);
if _e847 {
let _e848 = (_e846 % 16u);
let _e849 = (_e846 / 16u);
let _e852 = bitcast<i32>(((_e846 * 16u) + _e841));
let _e861 = global_3.member.member_13.member_4;
let _e867 = global_3.member.member_19.member;
let _e877 = (_e126 - (_e861.member + ((f32(_e841) + 0.5f) * _e867.member)));
let _e878 = (_e127 - (_e861.member_1 + ((f32(_e848) + 0.5f) * _e867.member_1)));
let _e879 = (_e128 - (_e861.member_2 + ((f32(_e849) + 0.5f) * _e867.member_2)));
let _e884 = (((_e841 == _e77.x) && (_e848 == _e101)) && (_e849 == _e102));
let _e889 = (((_e877 * _e877) + (_e878 * _e878)) + (_e879 * _e879));
let _e892 = sqrt(select(0f, _e889, (_e889 > 0f)));
let _e895 = (1f / select(1e-20f, _e892, (_e892 > 1e-20f)));
let _e896 = (_e877 * _e895);
let _e897 = (_e878 * _e895);
let _e898 = (_e879 * _e895);
local_3 = _e852;
let _e899 = local_3;
let _e901 = select(_e135, _e899, (_e899 < _e135));
let _e906 = global_4.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e907 = local_3;
let _e908 = (4096i + _e907);
let _e910 = select(_e135, _e908, (_e908 < _e135));
let _e915 = global_4.member[bitcast<u32>(select(0i, _e910, (_e910 > 0i)))];
let _e916 = local_3;
let _e917 = (8192i + _e916);
let _e919 = select(_e135, _e917, (_e917 < _e135));
let _e924 = global_4.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e925 = local_3;
let _e926 = (12288i + _e925);
let _e928 = select(_e135, _e926, (_e926 < _e135));
let _e933 = global_4.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e934 = local_3;
let _e935 = (16384i + _e934);
let _e937 = select(_e135, _e935, (_e935 < _e135));
let _e942 = global_4.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e943 = local_3;
let _e944 = (20480i + _e943);
let _e946 = select(_e135, _e944, (_e944 < _e135));
let _e951 = global_4.member[bitcast<u32>(select(0i, _e946, (_e946 > 0i)))];
let _e952 = local_3;
let _e953 = (24576i + _e952);
let _e955 = select(_e135, _e953, (_e953 < _e135));
let _e960 = global_4.member[bitcast<u32>(select(0i, _e955, (_e955 > 0i)))];
let _e961 = local_3;
let _e962 = (28672i + _e961);
let _e964 = select(_e135, _e962, (_e962 < _e135));
let _e969 = global_4.member[bitcast<u32>(select(0i, _e964, (_e964 > 0i)))];
local_2 = _e852;
let _e970 = local_2;
let _e972 = (bitcast<i32>(_e84) - 1i);
let _e974 = select(_e972, _e970, (_e970 < _e972));
let _e979 = global_5.member[bitcast<u32>(select(0i, _e974, (_e974 > 0i)))];
let _e980 = local_2;
let _e981 = (4096i + _e980);
let _e983 = select(_e972, _e981, (_e981 < _e972));
let _e988 = global_5.member[bitcast<u32>(select(0i, _e983, (_e983 > 0i)))];
let _e989 = local_2;
let _e990 = (8192i + _e989);
let _e992 = select(_e972, _e990, (_e990 < _e972));
let _e997 = global_5.member[bitcast<u32>(select(0i, _e992, (_e992 > 0i)))];
let _e998 = local_2;
let _e999 = (12288i + _e998);
let _e1001 = select(_e972, _e999, (_e999 < _e972));
let _e1006 = global_5.member[bitcast<u32>(select(0i, _e1001, (_e1001 > 0i)))];
let _e1007 = local_2;
let _e1008 = (16384i + _e1007);
let _e1010 = select(_e972, _e1008, (_e1008 < _e972));
let _e1015 = global_5.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1016 = local_2;
let _e1017 = (20480i + _e1016);
let _e1019 = select(_e972, _e1017, (_e1017 < _e972));
let _e1024 = global_5.member[bitcast<u32>(select(0i, _e1019, (_e1019 > 0i)))];
let _e1025 = local_2;
let _e1026 = (24576i + _e1025);
let _e1028 = select(_e972, _e1026, (_e1026 < _e972));
let _e1033 = global_5.member[bitcast<u32>(select(0i, _e1028, (_e1028 > 0i)))];
let _e1034 = local_2;
let _e1035 = (28672i + _e1034);
let _e1037 = select(_e972, _e1035, (_e1035 < _e972));
let _e1042 = global_5.member[bitcast<u32>(select(0i, _e1037, (_e1037 > 0i)))];
let _e1045 = global_3.member.member_19.member_2;
let _e1047 = select((_e1045 * _e960), 0f, _e884);
let _e1053 = (_e1047 * _e1047);
let _e1057 = ((1f + _e1053) - ((2f * _e1047) * (((_e933 * _e896) + (_e942 * _e897)) + (_e951 * _e898))));
let _e1059 = select(1e-9f, _e1057, (_e1057 > 1e-9f));
let _e1066 = (((1f - _e1053) / (_e1059 * sqrt(select(0f, _e1059, (_e1059 > 0f))))) * _e969);
let _e1071 = select((_e1045 * _e1033), 0f, _e884);
let _e1077 = (_e1071 * _e1071);
let _e1081 = ((1f + _e1077) - ((2f * _e1071) * (((_e1006 * _e896) + (_e1015 * _e897)) + (_e1024 * _e898))));
let _e1083 = select(1e-9f, _e1081, (_e1081 > 1e-9f));
let _e1090 = (((1f - _e1077) / (_e1083 * sqrt(select(0f, _e1083, (_e1083 > 0f))))) * _e1042);
let _e1099 = (bitcast<i32>(_e849) - bitcast<i32>(_e102));
if (_e1099 < 0i) {
phi_2156_ = -(_e1099);
} else {
phi_2156_ = _e1099;
}
let _e1103 = phi_2156_;
let _e1107 = (bitcast<i32>(_e848) - bitcast<i32>(_e101));
if (_e1107 < 0i) {
phi_2167_ = -(_e1107);
} else {
phi_2167_ = _e1107;
}
let _e1111 = phi_2167_;
let _e1116 = (bitcast<i32>(_e841) - bitcast<i32>(_e77.x));
if (_e1116 < 0i) {
phi_2179_ = -(_e1116);
} else {
phi_2179_ = _e1116;
}
let _e1120 = phi_2179_;
local_4 = ((((_e1103 * 16i) + _e1111) * 16i) + _e1120);
let _e1124 = global_3.member.member_19.member_3;
let _e1125 = bitcast<i32>(_e1124);
let _e1126 = local_4;
let _e1127 = (_e1125 + _e1126);
let _e1129 = (bitcast<i32>(_e87) - 1i);
let _e1131 = select(_e1129, _e1127, (_e1127 < _e1129));
let _e1136 = global_1.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1138 = local_4;
let _e1139 = ((_e1125 + 4096i) + _e1138);
let _e1141 = select(_e1129, _e1139, (_e1139 < _e1129));
let _e1146 = global_1.member[bitcast<u32>(select(0i, _e1141, (_e1141 > 0i)))];
let _e1148 = local_4;
let _e1149 = ((_e1125 + 8192i) + _e1148);
let _e1151 = select(_e1129, _e1149, (_e1149 < _e1129));
let _e1156 = global_1.member[bitcast<u32>(select(0i, _e1151, (_e1151 > 0i)))];
let _e1161 = local_4;
let _e1162 = ((_e1125 + 12288i) + _e1161);
let _e1164 = select(_e1129, _e1162, (_e1162 < _e1129));
let _e1169 = global_1.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1170 = (((0.5f * (_e969 + _e142)) - 1f) * _e1169);
let _e1173 = global_3.member.member_13.member;
let _e1178 = -((_e1173.member * _e1170));
let _e1180 = select(-87f, _e1178, (_e1178 > -87f));
let _e1182 = select(88f, _e1180, (_e1180 < 88f));
let _e1184 = ((_e1182 * 1.442695f) + 0.5f);
let _e1186 = select(-127f, _e1184, (_e1184 > -127f));
let _e1188 = select(128f, _e1186, (_e1186 < 128f));
let _e1195 = select(0i, select(select(i32(_e1188), i32(-2147483648), (_e1188 < -2147483600f)), 2147483647i, (_e1188 > 2147483500f)), (_e1188 == _e1188));
let _e1199 = (_e1195 - select(0i, 1i, (_e1188 < f32(_e1195))));
let _e1200 = f32(_e1199);
let _e1204 = ((_e1182 - (_e1200 * 0.6933594f)) - (_e1200 * -2.1219444e-4f));
let _e1226 = -((_e1173.member_1 * _e1170));
let _e1228 = select(-87f, _e1226, (_e1226 > -87f));
let _e1230 = select(88f, _e1228, (_e1228 < 88f));
let _e1232 = ((_e1230 * 1.442695f) + 0.5f);
let _e1234 = select(-127f, _e1232, (_e1232 > -127f));
let _e1236 = select(128f, _e1234, (_e1234 < 128f));
let _e1243 = select(0i, select(select(i32(_e1236), i32(-2147483648), (_e1236 < -2147483600f)), 2147483647i, (_e1236 > 2147483500f)), (_e1236 == _e1236));
let _e1247 = (_e1243 - select(0i, 1i, (_e1236 < f32(_e1243))));
let _e1248 = f32(_e1247);
let _e1252 = ((_e1230 - (_e1248 * 0.6933594f)) - (_e1248 * -2.1219444e-4f));
let _e1274 = -((_e1173.member_2 * _e1170));
let _e1276 = select(-87f, _e1274, (_e1274 > -87f));
let _e1278 = select(88f, _e1276, (_e1276 < 88f));
let _e1280 = ((_e1278 * 1.442695f) + 0.5f);
let _e1282 = select(-127f, _e1280, (_e1280 > -127f));
let _e1284 = select(128f, _e1282, (_e1282 < 128f));
let _e1291 = select(0i, select(select(i32(_e1284), i32(-2147483648), (_e1284 < -2147483600f)), 2147483647i, (_e1284 > 2147483500f)), (_e1284 == _e1284));
let _e1295 = (_e1291 - select(0i, 1i, (_e1284 < f32(_e1291))));
let _e1296 = f32(_e1295);
let _e1300 = ((_e1278 - (_e1296 * 0.6933594f)) - (_e1296 * -2.1219444e-4f));
let _e1324 = global_3.member.member_13.member_6;
let _e1327 = select(vec3<f32>(((1f + (_e1204 * (1f + (_e1204 * (0.5f + (_e1204 * (0.16666667f + (_e1204 * (0.041666668f + (_e1204 * (0.008333334f + (_e1204 * (0.001388889f + (_e1204 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1199 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e1252 * (1f + (_e1252 * (0.5f + (_e1252 * (0.16666667f + (_e1252 * (0.041666668f + (_e1252 * (0.008333334f + (_e1252 * (0.001388889f + (_e1252 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1247 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e1300 * (1f + (_e1300 * (0.5f + (_e1300 * (0.16666667f + (_e1300 * (0.041666668f + (_e1300 * (0.008333334f + (_e1300 * (0.001388889f + (_e1300 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1295 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(1f, 1f, 1f), vec3((_e1324 == 0u)));
let _e1339 = global_3.member.member_13.member_1;
let _e1346 = (0.25f / 3.1415927f);
let _e1347 = ((((((_e906 * _e1066) + (_e979 * _e1090)) * _e1136) * _e1327.x) * _e1339.member) * _e1346);
let _e1348 = ((((((_e915 * _e1066) + (_e988 * _e1090)) * _e1146) * _e1327.y) * _e1339.member_1) * _e1346);
let _e1349 = ((((((_e924 * _e1066) + (_e997 * _e1090)) * _e1156) * _e1327.z) * _e1339.member_2) * _e1346);
let _e1353 = (((_e1347 + _e1348) + _e1349) * (1f / 3f));
local_1 = array<f32, 6>(_e1347, _e1348, _e1349, (_e896 * _e1353), (_e897 * _e1353), (_e898 * _e1353));
phi_2535_ = 0u;
loop {
let _e1359 = phi_2535_;
let _e1360 = (_e1359 < 6u);
if _e1360 {
if _e1360 {
} else {
phi_2718_ = true;
break;
}
let _e1362 = local_1[_e1359];
if _e1360 {
} else {
phi_2718_ = true;
break;
}
let _e1364 = local_6[_e1359];
local_6[_e1359] = (_e1364 + _e1362);
phi_2536_ = (_e1359 + 1u);
} else {
phi_2536_ = u32();
}
let _e1368 = phi_2536_;
continue;
continuing {
phi_2535_ = _e1368;
phi_2718_ = _e844;
break if !(_e1360);
}
}
let _e1371 = phi_2718_;
phi_2794_ = _e1371;
if _e1371 {
break;
}
phi_2795_ = _e1371;
phi_1633_ = (_e846 + 1u);
} else {
phi_2795_ = _e844;
phi_1633_ = u32();
}
let _e1374 = phi_2795_;
let _e1376 = phi_1633_;
continue;
continuing {
phi_2785_ = _e1374;
phi_1632_ = _e1376;
phi_2794_ = _e1374;
break if !(_e847);
}
}
let _e1379 = phi_2794_;
phi_2799_ = _e1379;
if _e1379 {
break;
}
let _e1380 = local_6;
local = _e1380;
phi_2579_ = 0u;
loop {
let _e1382 = phi_2579_;
let _e1383 = (_e1382 < 6u);
if _e1383 {
if _e1383 {
} else {
phi_2796_ = true;
break;
}
let _e1385 = local[_e1382];
if _e1383 {
} else {
phi_2796_ = true;
break;
}
let _e1387 = local_5[_e1382];
local_5[_e1382] = (_e1387 + _e1385);
phi_2580_ = (_e1382 + 1u);
} else {
phi_2580_ = u32();
}
let _e1391 = phi_2580_;
continue;
continuing {
phi_2579_ = _e1391;
phi_2796_ = _e1379;
break if !(_e1383);
}
}
let _e1394 = phi_2796_;
phi_2799_ = _e1394;
if _e1394 {
break;
}
phi_2800_ = _e1394;
phi_1623_ = (_e841 + 1u);
} else {
phi_2800_ = _e839;
phi_1623_ = u32();
}
let _e1397 = phi_2800_;
let _e1399 = phi_1623_;
continue;
continuing {
phi_2786_ = _e1397;
phi_1622_ = _e1399;
phi_2799_ = _e1397;
break if !(_e842);
}
}
let _e1402 = phi_2799_;
if _e1402 {
break;
}
let _e1403 = local_5;
phi_2615_ = array<f32, 6>(_e1403[0], _e1403[1], _e1403[2], _e1403[3], _e1403[4], _e1403[5]);
}
let _e1412 = phi_2615_;
let _e1420 = select(0f, _e1412[0], (_e1412[0] > 0f));
let _e1422 = select(0f, _e1412[1], (_e1412[1] > 0f));
let _e1424 = select(0f, _e1412[2], (_e1412[2] > 0f));
let _e1428 = (((_e1420 + _e1422) + _e1424) * (1f / 3f));
let _e1433 = (((_e1412[3] * _e1412[3]) + (_e1412[4] * _e1412[4])) + (_e1412[5] * _e1412[5]));
let _e1436 = sqrt(select(0f, _e1433, (_e1433 > 0f)));
let _e1439 = (1f / select(1e-30f, _e1436, (_e1436 > 1e-30f)));
let _e1445 = (_e1436 / select(1e-30f, _e1428, (_e1428 > 1e-30f)));
global_2.member[_e99] = _e1420;
global_2.member[(_e97 + _e99)] = _e1422;
global_2.member[((2u * _e97) + _e99)] = _e1424;
global_2.member[((3u * _e97) + _e99)] = (_e1412[3] * _e1439);
global_2.member[((4u * _e97) + _e99)] = (_e1412[4] * _e1439);
global_2.member[((5u * _e97) + _e99)] = (_e1412[5] * _e1439);
global_2.member[((6u * _e97) + _e99)] = select(1f, _e1445, (_e1445 < 1f));
global_2.member[((7u * _e97) + _e99)] = _e142;
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
